#pragma once

#include <QTimer>

#include "core/base/result.h"
#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/choice_summary.h"

class QBoxLayout;
class QLabel;

namespace kickstand::ui {

class HighVoltageBox;
class RobotChoice;
class WheelsBox;

/// Drives all robots that are chosen, and always shows what they were told. What it shows comes from the
/// snapshot; only while a wish of a person is on its way does it show the wish.
class DrivePanel final : public Panel {
    Q_OBJECT
  public:
    DrivePanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

    /// Stops whatever moves, charges or is armed.
    void closed() override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void connectBoxes();
    void refresh();
    void reset();
    QString reasonNotToDrive(const thunderbots::Snapshot* snapshot) const;
    void showTold();
    bool mayFollow(TimePoint snapshotTime) const;

    void askWheel(int wheel, int value, bool held);
    void askZero();
    void sendWheels();
    void sendLate();
    void passZero();
    void ask(const thunderbots::Command& command);
    void answered(const Result<void>& result);

    RobotChoice& choice_;
    QBoxLayout* boxes_;
    WheelsBox* wheels_;
    HighVoltageBox* voltage_;
    QLabel* told_;
    QLabel* notice_;

    ChoiceSummary summary_;
    std::array<bool, thunderbots::kWheels> differs_{};  ///< Wheels whose set points are each robot's own.
    thunderbots::RobotMask passedZero_ = 0;
    std::uint64_t connections_ = 0;
    int waiting_ = 0;
    TimePoint answeredAt_{};
    QString refusal_;
    bool held_ = false;
    bool late_ = false;  ///< There is a newer wish than the last one sent.
    QTimer pace_;
    QTimer ages_;
};

}  // namespace kickstand::ui
