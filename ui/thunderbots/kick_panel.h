#pragma once

#include <QTimer>
#include <array>
#include <optional>

#include "core/base/result.h"
#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/choice_summary.h"
#include "ui/thunderbots/kick_settings.h"

class QLabel;
class QPushButton;

namespace kickstand::ui {

class HighVoltageBox;
class KickFields;
class KickPulsesView;
class RobotChoice;

/// Kicks, chips, and arms autokick: the pulses drawn to scale, what goes onto the wire, and what the last
/// kick did. Why a button cannot be pressed stands beside it and in its tooltip.
class KickPanel final : public Panel {
    Q_OBJECT
  public:
    KickPanel(Bench& bench, RobotChoice& choice, KickSettings& kick, QWidget* parent = nullptr);

    QWidget* headerTools() override;
    /// Stops whatever moves, charges or is armed.
    void closed() override;

  private:
    QWidget* makePulses();
    QWidget* makeButtons();
    QWidget* makeAutokick();
    QWidget* makeVoltage();
    void connectAll();
    void refresh();
    void showPulses();
    void showButtons(const thunderbots::Snapshot* snapshot);
    void showLines(const thunderbots::Snapshot& snapshot, const QString& reason);
    void showVoltage(const thunderbots::Snapshot& snapshot, const QString& reason);
    void showDrop(const thunderbots::Snapshot& snapshot);
    /// Of the chosen robots; null for none.
    const thunderbots::KickRecord* lastKick(const thunderbots::Snapshot& snapshot) const;
    QString autokickText(const thunderbots::Snapshot& snapshot) const;
    QString lastKickText(const thunderbots::Snapshot& snapshot) const;

    void kick(KickWay way);
    void armAutokick(bool armed);
    void rename(KickWay way);
    void ask(const thunderbots::Command& command);
    QPushButton* button(KickWay way) const { return ways_[static_cast<std::size_t>(way)]; }

    RobotChoice& choice_;
    KickSettings& kick_;
    KickPulsesView* view_ = nullptr;
    KickFields* fields_ = nullptr;
    QLabel* wire_ = nullptr;
    std::array<QPushButton*, kKickWays.size()> ways_{};
    QPushButton* autokick_ = nullptr;
    QLabel* autokickLine_ = nullptr;
    QLabel* notice_ = nullptr;
    HighVoltageBox* voltage_ = nullptr;
    QLabel* charge_ = nullptr;
    QLabel* drop_ = nullptr;
    QLabel* dropWhat_ = nullptr;

    ChoiceSummary summary_;
    QString snapped_;
    QString refusal_;
    int waiting_ = 0;
    QTimer ages_;
};

}  // namespace kickstand::ui
