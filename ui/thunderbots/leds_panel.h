#pragma once

#include <QTimer>

#include "core/base/result.h"
#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/leds_words.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace kickstand::ui {

class LedLights;
class RobotChoice;
class Segmented;

/// The test modes of the robots' four LEDs: chosen by name, sent to all robots that are chosen, and told
/// apart by how they were asked for.
class LedsPanel final : public Panel {
    Q_OBJECT
  public:
    LedsPanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

  private:
    void build();
    QWidget* makeWays();
    void connectControls();
    void fillTargets();
    void followChoice();
    thunderbots::wire::TestMode wanted() const;
    void ask();
    void askNormal();
    void submit(thunderbots::RobotMask robots, const thunderbots::wire::TestMode& mode,
                thunderbots::TestModeWay way);
    void answered(const Result<void>& result);
    void refresh();
    void showTold(const thunderbots::Snapshot& snapshot);
    QString reasonNotTo(const thunderbots::Snapshot* snapshot) const;
    QString stateText(const LedState& state) const;
    QString sinceText(TimePoint since) const;

    RobotChoice& choice_;
    QComboBox* class_;
    QComboBox* target_;
    Segmented* way_;
    LedLights* lights_;
    QLabel* advice_;
    QPushButton* normal_;
    QLabel* told_;
    QLabel* notice_;
    thunderbots::TestModeWay chosenWay_ = thunderbots::TestModeWay::Message;
    thunderbots::RobotMask live_ = 0;
    QString refusal_;
    QTimer ages_;
};

}  // namespace kickstand::ui
