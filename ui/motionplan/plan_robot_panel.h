#pragma once

#include <array>

#include "core/motionplan/commands.h"
#include "core/motionplan/snapshot.h"
#include "ui/shell/panel.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

class PlanDocument;

/// The robot: what it executes, what is in its slots and its trigger plan, and the buttons that send, start,
/// adjust and stop.
class PlanRobotPanel final : public Panel {
    Q_OBJECT
  public:
    PlanRobotPanel(Bench& bench, PlanDocument& document, QWidget* parent = nullptr);

  private:
    struct SlotRow {
        QLabel* text = nullptr;
        QPushButton* send = nullptr;
        QPushButton* execute = nullptr;
    };

    void build();
    QWidget* makeSlots();
    QWidget* makeTrigger();
    QWidget* makeSpeed();
    void connectButtons();
    void submit(const motionplan::Command& command);
    void sendTo(int slot);
    void execute(int slot);
    void queryAll();
    void refresh();
    void refreshSlot(int slot, const motionplan::Snapshot* snapshot);
    /// Takes away a refusal that Stop, the robot's own word or another connection has settled.
    void dropSettledRefusal(const motionplan::Snapshot& snapshot);
    void refreshTrigger(const motionplan::Snapshot* snapshot);
    /// Why nothing can be asked of the robot now; empty where it can.
    QString obstacle(const motionplan::Snapshot* snapshot) const;
    QString executionText(const motionplan::Snapshot& snapshot) const;
    QString progressText(const motionplan::Snapshot& snapshot) const;
    /// What STOP cannot do.
    QString warningText(const motionplan::TriggerState& trigger) const;

    PlanDocument& document_;
    QLabel* state_;
    QLabel* progress_;
    QLabel* warning_;
    QPushButton* stop_;
    QPushButton* query_;
    QSpinBox* id_;
    std::array<SlotRow, motionplan::wire::kSlots> rows_;
    QLabel* trigger_;
    QPushButton* setTrigger_;
    QPushButton* readTrigger_;
    QComboBox* wheels_;
    QSpinBox* change_;
    QPushButton* adjust_;
    QLabel* notice_;
    QString refusal_;
    motionplan::Execution::State executed_ = motionplan::Execution::State::Idle;  ///< When last shown.
    TimePoint stoppedAt_{};
    std::uint64_t connections_ = 0;
    bool starting_ = false;  ///< An Execute is not answered yet.
};

}  // namespace kickstand::ui
