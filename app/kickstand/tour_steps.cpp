#include "app/kickstand/tour_steps.h"

#include <QAbstractButton>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QPixmap>
#include <QSpinBox>
#include <algorithm>

#include "ui/shell/bench.h"
#include "ui/shell/main_window.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::app {

namespace {

using namespace thunderbots;

/// The robot that the tour plays with.
constexpr int kRobot = 3;

/// Makes the steps: what each does, it does with the controls that a person would use.
class Steps {
  public:
    Steps(ui::MainWindow& window, ui::Bench& bench) : window_(window), bench_(bench) {}

    std::vector<TourStep> all() && {
        connecting();
        driving();
        charging();
        stopping();
        losing();
        leaving();
        return std::move(steps_);
    }

  private:
    void connecting();
    void driving();
    void charging();
    void stopping();
    void losing();
    void leaving();

    using Act = std::function<void()>;
    using Done = std::function<bool()>;

    void add(const char* name, const Act& act, const Done& done) {
        steps_.push_back({QString::fromLatin1(name), act, done, {}});
    }
    void show(const char* name, const Act& act, const Done& done) {
        steps_.push_back(
            {QString::fromLatin1(name), act, done, [window = &window_] { return window->grab(); }});
    }
    /// With another window drawn over the first.
    void showOver(const char* name, const Act& act, const Done& done, const std::function<QWidget*()>& over) {
        steps_.push_back({QString::fromLatin1(name), act, done, [window = &window_, over] {
                              QPixmap picture = window->grab();
                              if (QWidget* top = over()) {
                                  QPainter painter(&picture);
                                  painter.drawPixmap(
                                      top->mapToGlobal(QPoint()) - window->mapToGlobal(QPoint()),
                                      top->grab());
                              }
                              return picture;
                          }});
    }

    // The closures below outlive this object: they hold the window and the bench themselves.
    Act press(const char* name) const {
        return [window = &window_, name] {
            if (auto* button = window->findChild<QAbstractButton*>(QLatin1String(name))) button->click();
        };
    }
    Act simulate(const char* action, int unit, double value) const {
        return [bench = &bench_, action, unit, value] { bench->submit(SimPerform{action, unit, value}); };
    }
    Done when(const std::function<bool(const Snapshot&)>& holds) const {
        return [bench = &bench_, holds] {
            const Snapshot* snapshot = ui::snapshotOf(bench->session());
            return snapshot != nullptr && holds(*snapshot);
        };
    }
    Done whenRobot(const std::function<bool(const RobotState&)>& holds) const {
        return when([holds](const Snapshot& snapshot) { return holds(snapshot.robots[kRobot]); });
    }
    static bool always() { return true; }

    ui::MainWindow& window_;
    ui::Bench& bench_;
    std::vector<TourStep> steps_;
};

void Steps::connecting() {
    show(
        "start", [] {}, [bench = &bench_] { return bench->client().snapshot().discovered; });
    showOver(
        "connect-menu",
        [window = &window_] {
            auto* button = window->findChild<QAbstractButton*>(QStringLiteral("connect"));
            window->findChild<QMenu*>(QStringLiteral("connectMenu"))
                ->popup(button->mapToGlobal(button->rect().bottomLeft() + QPoint(0, 4)));
        },
        always, [window = &window_] { return window->findChild<QMenu*>(QStringLiteral("connectMenu")); });
    add(
        "close-menu",
        [window = &window_] { window->findChild<QMenu*>(QStringLiteral("connectMenu"))->close(); }, always);
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
        [window = &window_] {
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
        [window = &window_] {
            auto* stop = window->findChild<QAbstractButton*>(QStringLiteral("stop"));
            stop->setDown(true);
            emit stop->pressed();
            stop->setDown(false);
        },
        [bench = &bench_] {
            const Snapshot* snapshot = ui::snapshotOf(bench->session());
            return bench->client().isStopped() && snapshot != nullptr &&
                   snapshot->robots[kRobot].told == wire::brakedBlock();
        });
    show("re-armed", press("rearm"), [bench = &bench_] { return !bench->client().isStopped(); });
    show("e-stop", simulate("e-stop", -1, 2),
         when([](const Snapshot& s) { return s.eStop == wire::EStop::Stop; }));
    add("e-stop-run", simulate("e-stop", -1, 3),
        when([](const Snapshot& s) { return s.eStop == wire::EStop::Run; }));
    add("re-arm", press("rearm"), [bench = &bench_] { return !bench->client().isStopped(); });
}

void Steps::losing() {
    show("treat-as-live", simulate("dead", kRobot, 1),
         whenRobot([](const RobotState& robot) { return !robot.live; }));
    show(
        "filtered-events",
        [window = &window_] {
            window->findChild<QLineEdit*>(QStringLiteral("eventText"))->setText(QStringLiteral("battery"));
        },
        always);
    add(
        "all-events",
        [window = &window_] { window->findChild<QLineEdit*>(QStringLiteral("eventText"))->clear(); }, always);
    show("unplugged", simulate("plugged", -1, 0),
         when([](const Snapshot& snapshot) { return snapshot.link == LinkState::Searching; }));
    show("plugged-in", simulate("plugged", -1, 1), when([](const Snapshot& s) {
             return s.link == LinkState::Running && s.robots[0].freshness == Freshness::Current;
         }));
}

void Steps::leaving() {
    const auto warning = [window = &window_] {
        return window->findChild<QMessageBox*>(QStringLiteral("liveWarning"));
    };
    showOver(
        "live-warning", [window = &window_] { window->close(); },
        [warning] { return warning() != nullptr && warning()->isVisible(); }, warning);
    add("stay", press("stay"), [warning] { return warning() == nullptr || !warning()->isVisible(); });
    steps_.push_back(
        {QStringLiteral("help"), [window = &window_] { window->showHelp(QStringLiteral("bench-guide.md")); },
         always,
         [window = &window_] { return window->findChild<QWidget*>(QStringLiteral("help"))->grab(); }});
    add(
        "disconnect", [bench = &bench_] { bench->disconnectAll(); },
        [bench = &bench_] { return bench->session() == nullptr; });
}

}  // namespace

std::vector<TourStep> tourSteps(ui::MainWindow& window, ui::Bench& bench) {
    return Steps(window, bench).all();
}

}  // namespace kickstand::app
