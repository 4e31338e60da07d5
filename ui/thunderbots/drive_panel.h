#pragma once

#include <QTimer>

#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/body_motion.h"

class QBoxLayout;
class QLabel;

namespace kickstand::ui {

class DriveControl;
class DriveKeysBox;
class HighVoltageBox;
class WheelsBox;

/// Drives all robots that are chosen, and always shows what they were told. What it shows comes from the
/// snapshot; only while a wish of a person is on its way does it show the wish.
class DrivePanel final : public Panel {
    Q_OBJECT
  public:
    DrivePanel(Bench& bench, DriveControl& control, QWidget* parent = nullptr);

    /// What the robots were told.
    QWidget* headerTools() override;
    /// Stops whatever moves, charges or is armed.
    void closed() override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void build();
    void chooseUnit();
    void connectWheels();
    void connectVoltage();
    void refresh();
    void showTold();
    void showNotice();
    void keysAsked(const BodyMotion& part);
    void ask(const thunderbots::Command& command);

    DriveControl& control_;
    QBoxLayout* boxes_;
    WheelsBox* wheels_;
    DriveKeysBox* keys_;
    HighVoltageBox* voltage_;
    QLabel* told_;
    QLabel* notice_;
    int waiting_ = 0;
    QString refusal_;
    QString keyNotice_;
    QTimer ages_;
};

}  // namespace kickstand::ui
