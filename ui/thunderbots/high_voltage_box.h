#pragma once

#include <QWidget>

#include "ui/thunderbots/choice_summary.h"

class QLabel;
class QPushButton;

namespace kickstand::ui {

class CapacitorReadout;

/// The kicker's capacitor: how much is on it, and the three things that need the high voltage armed first.
class HighVoltageBox final : public QWidget {
    Q_OBJECT
  public:
    /// `owner` begins the names of its buttons, so that those of two boxes are told apart: "kick" makes
    /// "kickArm"; without one they are "arm", "charger" and "discharge".
    explicit HighVoltageBox(const QString& owner, QWidget* parent = nullptr);

    /// `buttons`: whether they may follow the snapshot, or a person's wish is still on its way.
    void showState(const ChoiceSummary& summary, TimePoint now, bool buttons);
    /// Why nothing of it can be used; empty where it can.
    void setObstacle(const QString& reason);

  signals:
    void armAsked(bool on);
    void chargerAsked(bool on);
    void dischargeAsked(bool on);

  private:
    void refreshUsable();

    CapacitorReadout* readout_;
    QPushButton* arm_;
    QPushButton* charger_;
    QPushButton* discharge_;
    QLabel* why_;
    QString obstacle_;
    bool armed_ = false;
};

}  // namespace kickstand::ui
