#pragma once

#include <QString>
#include <array>
#include <vector>

#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

// The test LEDs in words: what a robot shows and what each of its four lights means (protocol 4.2, 4.5).

/// What one of the four LEDs does in a mode.
struct LedMeaning {
    enum class Kind {
        Unused,  ///< Dark, or without meaning.
        On,      ///< Lit all the time.
        Signal,  ///< Shows a signal of the robot, which no pipe carries: a person has to look.
    };
    Kind kind = Kind::Unused;
    QString mark;  ///< A letter or two under the light.
    QString text;  ///< "Encoder line A".
};

/// The classes in the order that they are offered.
std::vector<thunderbots::wire::TestClass> ledClasses();
/// "Encoder lines".
QString ledClassText(thunderbots::wire::TestClass testClass);
/// "Wheel 2, back left", "Motor 5, dribbler": as on the robot.
QString ledTargetText(thunderbots::wire::TestClass testClass, int target);
/// "encoder lines of wheel 2, back left".
QString ledModeText(const thunderbots::wire::TestMode& mode);
/// LED 0 first.
std::array<LedMeaning, 4> ledMeanings(const thunderbots::wire::TestMode& mode);
/// What to do, and what should be seen then.
QString ledAdvice(const thunderbots::wire::TestMode& mode);

/// What a robot's LEDs show, as far as it was told on this connection.
struct LedState {
    std::optional<thunderbots::wire::TestMode> message;  ///< None: nothing on this connection.
    TimePoint messageSince{};
    thunderbots::wire::TestMode block;  ///< What its drive blocks ask for.
    TimePoint blockSince{};

    bool showsBlock() const { return block.testClass != thunderbots::wire::TestClass::None; }
    friend bool operator==(const LedState&, const LedState&) = default;
};
LedState ledStateOf(const thunderbots::RobotState& robot);

}  // namespace kickstand::ui
