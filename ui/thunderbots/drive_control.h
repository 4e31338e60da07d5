#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/base/result.h"
#include "core/thunderbots/commands.h"
#include "ui/thunderbots/choice_summary.h"

namespace kickstand::ui {

class Bench;
class RobotChoice;

/// What can drive robots by hand.
enum class DriveInput { Panel, Keys, Gamepad };

/// Drives the chosen robots for whoever has a hand on something: sliders, keys, a gamepad. It sends no faster
/// than the link can use, lets only one input drive at a time, and tells all of them to let go when what they
/// hold must not count any more. GUI thread.
class DriveControl final : public QObject {
    Q_OBJECT
  public:
    explicit DriveControl(RobotChoice& choice);

    /// Once, before anything else. It must outlive this.
    void attach(Bench& bench);

    const ChoiceSummary& summary() const { return summary_; }
    int limit() const { return limit_; }
    /// What the robots are to do: the last wish, or the snapshot's once that is newer.
    const thunderbots::WheelSpeeds& wheels() const { return wish_; }
    /// Whether a wheel's set point is each robot's own.
    bool differs(int wheel) const { return differs_[static_cast<std::size_t>(wheel)]; }
    /// Whether what is shown may follow the snapshot: no wish is on its way.
    bool followsSnapshot() const { return follows_; }
    /// Why nothing can be driven, as a sentence; empty where it can.
    const QString& reasonNotToDrive() const { return reason_; }
    /// Why the last wish was refused; empty where it was not.
    const QString& refusal() const { return refusal_; }
    std::optional<DriveInput> driver() const { return driver_; }

    /// One wheel; those that differ between the robots stay as they are.
    void setWheel(int wheel, int speed, bool held);
    /// All of them. False where another input drives: this one must be let go before it counts.
    bool setWheels(DriveInput input, const thunderbots::WheelSpeeds& wheels, bool held);
    /// Releases the brakes at the set points as they are.
    void run();
    void zero();
    void brake();
    void setDribbler(bool on);
    void setLimit(int limit);

  signals:
    void changed();
    /// Whatever is held must be let go before it counts again: STOP, another choice, another connection.
    void dropped();

  private:
    void drop();
    void refresh();
    QString findReason(const thunderbots::Snapshot* snapshot) const;
    bool mayDrive(DriveInput input, bool held, bool moving);
    void send();
    void sendSoon();
    void sendLate();
    void passZero();
    void ask(const thunderbots::Command& command);
    void answered(const Result<void>& result);

    RobotChoice& choice_;
    Bench* bench_ = nullptr;
    ChoiceSummary summary_;
    int limit_ = thunderbots::kStartingWheelLimit;
    thunderbots::WheelSpeeds wish_{};
    std::array<bool, thunderbots::kWheels> differs_{};
    bool follows_ = true;
    bool held_ = false;
    bool late_ = false;  ///< There is a newer wish than the last one sent.
    std::optional<DriveInput> driver_;
    thunderbots::RobotMask passedZero_ = 0;
    std::uint64_t connections_ = 0;
    int waiting_ = 0;
    TimePoint answeredAt_{};
    QString reason_;
    QString refusal_;
    QTimer pace_;
};

}  // namespace kickstand::ui
