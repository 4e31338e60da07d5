#include "ui/thunderbots/leds_words.h"

#include <QCoreApplication>

namespace kickstand::ui {

using namespace thunderbots;
using wire::TestClass;
using wire::TestMode;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Leds)
};

constexpr int kDribblerMotor = 5;

QString place(int motor) {
    switch (motor) {
        case 1:
            return Words::tr("front left");
        case 2:
            return Words::tr("back left");
        case 3:
            return Words::tr("back right");
        case 4:
            return Words::tr("front right");
        default:
            return Words::tr("dribbler");
    }
}

LedMeaning signal(const QString& mark, const QString& text) {
    return {LedMeaning::Kind::Signal, mark, text};
}

}  // namespace

std::vector<TestClass> ledClasses() {
    return {TestClass::None,    TestClass::Lamp,         TestClass::Hall,
            TestClass::Encoder, TestClass::EncoderCount, TestClass::Charger};
}

QString ledClassText(TestClass testClass) {
    switch (testClass) {
        case TestClass::None:
            return Words::tr("Normal lights");
        case TestClass::Lamp:
            return Words::tr("All four on");
        case TestClass::Hall:
            return Words::tr("Hall sensors");
        case TestClass::Encoder:
            return Words::tr("Encoder lines");
        case TestClass::EncoderCount:
            return Words::tr("Encoder count");
        case TestClass::Charger:
            return Words::tr("Charger");
    }
    return Words::tr("class %1, which is not defined").arg(static_cast<int>(testClass));
}

QString ledTargetText(TestClass testClass, int target) {
    const QString named =
        testClass == TestClass::Hall ? Words::tr("Motor %1, %2") : Words::tr("Wheel %1, %2");
    return named.arg(target).arg(place(target));
}

QString ledModeText(const TestMode& mode) {
    const QString shown = ledClassText(mode.testClass);
    if (!wire::targetsOf(mode.testClass).any()) return shown;
    const QString target = ledTargetText(mode.testClass, mode.target);
    return Words::tr("%1: %2").arg(shown, target.left(1).toLower() + target.mid(1));
}

std::array<LedMeaning, 4> ledMeanings(const TestMode& mode) {
    switch (mode.testClass) {
        case TestClass::Lamp: {
            const LedMeaning on{LedMeaning::Kind::On, Words::tr("on"), Words::tr("Lit")};
            return {on, on, on, on};
        }
        case TestClass::Hall:
            return {signal(Words::tr("A"), Words::tr("Hall sensor A")),
                    signal(Words::tr("B"), Words::tr("Hall sensor B")),
                    signal(Words::tr("C"), Words::tr("Hall sensor C")),
                    {}};
        case TestClass::Encoder:
            return {signal(Words::tr("A"), Words::tr("Encoder line A")),
                    signal(Words::tr("B"), Words::tr("Encoder line B")),
                    {},
                    {}};
        case TestClass::EncoderCount:
            return {signal(QStringLiteral("1"), Words::tr("Bit 0 of the count")),
                    signal(QStringLiteral("2"), Words::tr("Bit 1 of the count")),
                    signal(QStringLiteral("4"), Words::tr("Bit 2 of the count")),
                    signal(QStringLiteral("8"), Words::tr("Bit 3 of the count"))};
        case TestClass::Charger:
            return {signal(Words::tr("pulse"), Words::tr("Each charge pulse")),
                    signal(Words::tr("late"), Words::tr("Charge time-out")),
                    {},
                    {}};
        default:
            return {};
    }
}

QString ledAdvice(const TestMode& mode) {
    switch (mode.testClass) {
        case TestClass::None:
            return Words::tr("The robot uses its lights for what its firmware wants.");
        case TestClass::Lamp:
            return Words::tr("All four should be lit: one that is dark is broken.");
        case TestClass::Hall:
            return mode.target == kDribblerMotor
                       ? Words::tr(
                             "Turn the dribbler by hand: one light after the other changes. All three "
                             "dark or all three lit is a fault.")
                       : Words::tr(
                             "Turn the wheel by hand: one light after the other changes. All three "
                             "dark or all three lit is a fault.");
        case TestClass::Encoder:
            return Words::tr("Turn the wheel by hand: the two lines should alternate.");
        case TestClass::EncoderCount:
            return Words::tr("Turn the wheel by hand: the low four bits count, LED 0 fastest.");
        case TestClass::Charger:
            return Words::tr(
                "Switch the charger on: LED 0 flickers until the capacitor is full. LED 1 lit: "
                "charging took too long.");
    }
    return {};
}

LedState ledStateOf(const RobotState& robot) {
    LedState state;
    state.message = robot.toldTestMode;
    if (robot.toldTestMode) state.messageSince = robot.toldTestModeAt;
    if (!robot.told || robot.told->testClass == 0) return state;
    // The drive block has room for numbers that mean nothing; they are named as such.
    state.block = {static_cast<TestClass>(robot.told->testClass), robot.told->testTarget};
    state.blockSince = robot.blockTestModeAt;
    return state;
}

}  // namespace kickstand::ui
