#pragma once

#include <QAbstractButton>
#include <QPainter>
#include <QPixmap>
#include <functional>
#include <vector>

#include "app/kickstand/tour.h"
#include "app/kickstand/tour_links.h"
#include "ui/shell/bench.h"
#include "ui/shell/main_window.h"
#include "ui/thunderbots/thunderbots_view.h"

namespace kickstand::app {

/// Makes the steps of the tour: what each does, it does with the controls that a person would use. The
/// closures that it makes outlive it: they hold the window, the bench and the bus themselves.
class TourMaker {
  public:
    using Act = std::function<void()>;
    using Done = std::function<bool()>;

    /// The robot that the tour plays with.
    static constexpr int kRobot = 3;

    TourMaker(ui::MainWindow& window, ui::Bench& bench, TourBus& bus)
        : window_(&window), bench_(&bench), bus_(&bus) {}

    std::vector<TourStep> steps() && { return std::move(steps_); }
    ui::MainWindow* window() const { return window_; }
    ui::Bench* bench() const { return bench_; }
    TourBus* bus() const { return bus_; }

    /// Without a picture.
    void add(const char* name, const Act& act, const Done& done = always);
    /// With a picture of the window.
    void show(const char* name, const Act& act, const Done& done = always);
    /// With another window drawn over the first.
    void showOver(const char* name, const Act& act, const Done& done, const std::function<QWidget*()>& over);
    /// With a picture of another window alone.
    void showWindow(const char* name, const Act& act, const Done& done,
                    const std::function<QWidget*()>& picture);

    /// Clicks a button of the window, by its name.
    Act press(const char* name) const;
    /// Brings a panel to the front, by its id.
    Act goTo(const char* place) const;
    Act simulate(const char* action, int unit, double value) const;
    Done when(const std::function<bool(const thunderbots::Snapshot&)>& holds) const;
    Done whenRobot(const std::function<bool(const thunderbots::RobotState&)>& holds) const;
    static bool always() { return true; }

  private:
    ui::MainWindow* window_;
    ui::Bench* bench_;
    TourBus* bus_;
    std::vector<TourStep> steps_;
};

/// Curves with the gap that a lost robot leaves: robot 3 is lost before, and heard again afterwards.
void addGapSteps(TourMaker& tour);
/// Test LEDs, experiment data, events, fault codes, simulated robots, and why it does not work.
void addLookingSteps(TourMaker& tour);
/// A kick and what it did, a sweep, autokick: with the robot charged and a ball in its beam.
void addKickingSteps(TourMaker& tour);
/// A bench check of robot 6, with its questions, to the report.
void addCheckSteps(TourMaker& tour);
/// The body's motion: robot 3 is chosen.
void addDrivingSteps(TourMaker& tour);
/// A gamepad: none, plugged in, an input given to another button, driving, lost, and back with its stick
/// held. Robot 3 is chosen.
void addGamepadSteps(TourMaker& tour);
/// A dongle that this user may not open, and what to do about it. Nothing is connected before.
void addForbiddenSteps(TourMaker& tour);
/// The smallest window that holds everything, with all sixteen tiles up to something, stopped, and with a
/// robot lost.
void addSmallSteps(TourMaker& tour);
/// Motion plans on a simulated NXT of its own, which is let go again: written, sent, half executed, stopped,
/// and the robot out of reach. Nothing is connected before.
void addMotionplanSteps(TourMaker& tour);
/// A simulated COACH and its boat, then a simulated boat of this program's own, then a fresh radio module;
/// each is let go again. Nothing is connected before.
void addCoachSteps(TourMaker& tour);
/// Smart devices: six simulated boards, driven, watched, stopped, pulled out. Nothing is connected before.
void addSmartdeviceSteps(TourMaker& tour);
/// Parameters: read, drafted, asked about, applied, committed, proven by a reboot, compared. Robot 3 is
/// chosen.
void addParameterSteps(TourMaker& tour);
/// An upload to robots 5 and 7, page by page, paused by STOP and resumed.
void addFirmwareSteps(TourMaker& tour);
/// The plots: cursors, a trigger, several robots. Robot 3 is chosen.
void addVoltagesSteps(TourMaker& tour);

}  // namespace kickstand::app
