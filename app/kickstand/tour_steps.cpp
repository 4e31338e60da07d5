#include "app/kickstand/tour_steps.h"

#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSpinBox>
#include <algorithm>

#include "app/kickstand/tour_maker.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::app {

namespace {

using namespace thunderbots;

constexpr int kRobot = TourMaker::kRobot;

/// The jobs that touch the whole window, in the order of a day at the bench.
class Steps final : public TourMaker {
  public:
    using TourMaker::TourMaker;

    std::vector<TourStep> all() && {
        connecting();
        driving();
        addDrivingSteps(*this);
        addGamepadSteps(*this);
        charging();
        addKickingSteps(*this);
        addVoltagesSteps(*this);
        addLookingSteps(*this);
        addCheckSteps(*this);
        addParameterSteps(*this);
        addFirmwareSteps(*this);
        stopping();
        losing();
        addGapSteps(*this);
        addSmallSteps(*this);
        leaving();
        addForbiddenSteps(*this);
        addMotionplanSteps(*this);
        addCoachSteps(*this);
        addSmartdeviceSteps(*this);
        return std::move(*this).steps();
    }

  private:
    void connecting();
    void driving();
    void charging();
    void stopping();
    void losing();
    void leaving();
};

void Steps::connecting() {
    show(
        "start", [] {}, [bench = bench()] { return bench->client().snapshot().discovered; });
    showOver(
        "connect-menu",
        [window = window()] {
            auto* button = window->findChild<QAbstractButton*>(QStringLiteral("connect"));
            window->findChild<QMenu*>(QStringLiteral("connectMenu"))
                ->popup(button->mapToGlobal(button->rect().bottomLeft() + QPoint(0, 4)));
        },
        always, [window = window()] { return window->findChild<QMenu*>(QStringLiteral("connectMenu")); });
    add(
        "close-menu",
        [window = window()] { window->findChild<QMenu*>(QStringLiteral("connectMenu"))->close(); }, always);
    show("connected", press("simulate"), when([](const Snapshot& snapshot) {
             return std::all_of(snapshot.robots.begin(), snapshot.robots.end(), [](const RobotState& robot) {
                 return robot.freshness == Freshness::Current;
             });
         }));
}

void Steps::driving() {
    add("choose", press("robot3"), always);
    show(
        "wheel",
        [window = window()] {
            window->findChild<ui::SetPointSlider*>(QStringLiteral("wheel3"))->field()->setValue(42);
        },
        whenRobot([](const RobotState& robot) { return robot.told && robot.told->wheels[2] == 42; }));
    add("dribbler", press("dribbler"),
        whenRobot([](const RobotState& robot) { return robot.told->dribble; }));
    show("raise-limit", press("changeLimit"), always);
    add("keep-limit", press("keepLimit"), always);
}

void Steps::charging() {
    add("arm", press("arm"),
        when([](const Snapshot& snapshot) { return snapshot.intents[kRobot].highVoltageArmed; }));
    add("ball", simulate("ball", kRobot, 1),
        whenRobot([](const RobotState& robot) { return robot.readings.ball; }));
    show("charged", press("charger"),
         whenRobot([](const RobotState& robot) { return robot.readings.charged; }));
}

void Steps::stopping() {
    show(
        "stopped",
        [window = window()] {
            auto* stop = window->findChild<QAbstractButton*>(QStringLiteral("stop"));
            stop->setDown(true);
            emit stop->pressed();
            stop->setDown(false);
        },
        [bench = bench()] {
            const Snapshot* snapshot = ui::snapshotOf(bench->session());
            return bench->client().isStopped() && snapshot != nullptr &&
                   snapshot->robots[kRobot].told == wire::brakedBlock();
        });
    show("re-armed", press("rearm"), [bench = bench()] { return !bench->client().isStopped(); });
    show("e-stop", simulate("e-stop", -1, 2),
         when([](const Snapshot& s) { return s.eStop == wire::EStop::Stop; }));
    add("e-stop-run", simulate("e-stop", -1, 3),
        [rearm = window()->findChild<QWidget*>(QStringLiteral("rearm"))] { return rearm->isEnabled(); });
    add("re-arm", press("rearm"), [bench = bench()] { return !bench->client().isStopped(); });
}

void Steps::losing() {
    show("treat-as-live", simulate("dead", kRobot, 1),
         whenRobot([](const RobotState& robot) { return !robot.live; }));
    show(
        "filtered-events",
        [window = window()] {
            window->findChild<QLineEdit*>(QStringLiteral("eventText"))->setText(QStringLiteral("battery"));
        },
        always);
    add(
        "all-events",
        [window = window()] { window->findChild<QLineEdit*>(QStringLiteral("eventText"))->clear(); }, always);
    show("unplugged", simulate("plugged", -1, 0),
         when([](const Snapshot& snapshot) { return snapshot.link == LinkState::Searching; }));
    show("plugged-in", simulate("plugged", -1, 1), when([](const Snapshot& s) {
             return s.link == LinkState::Running && s.robots[0].freshness == Freshness::Current;
         }));
}

void Steps::leaving() {
    const auto warning = [window = window()] {
        return window->findChild<QMessageBox*>(QStringLiteral("liveWarning"));
    };
    showOver(
        "live-warning", [window = window()] { window->close(); },
        [warning] { return warning() != nullptr && warning()->isVisible(); }, warning);
    add("stay", press("stay"), [warning] { return warning() == nullptr || !warning()->isVisible(); });
    showWindow(
        "help", [window = window()] { window->showHelp(QStringLiteral("bench-guide.md")); }, always,
        [window = window()] { return window->findChild<QWidget*>(QStringLiteral("help")); });
    add(
        "disconnect", [bench = bench()] { bench->disconnectAll(); },
        [bench = bench()] { return bench->session() == nullptr; });
}

}  // namespace

std::vector<TourStep> tourSteps(ui::MainWindow& window, ui::Bench& bench, TourBus& bus) {
    return Steps(window, bench, bus).all();
}

}  // namespace kickstand::app
