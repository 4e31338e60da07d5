#pragma once

#include <QWidget>

#include "core/thunderbots/sweep_plan.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSettings;

namespace kickstand::ui {

class SignedSpinBox;

/// The settings of a sweep, its start and stop, and how far it has come. It shows and asks; the panel
/// decides.
class KickSweepBox final : public QWidget {
    Q_OBJECT
  public:
    explicit KickSweepBox(QSettings& settings, QWidget* parent = nullptr);

    /// Start and stop, for a place where they are always seen.
    QWidget* buttons() const { return buttons_; }
    /// The plan as it is set, for a robot and the pulses that stay as they are.
    thunderbots::SweepPlan plan(int robot, const thunderbots::wire::KickPulses& pulses) const;
    /// Shows the running sweep or the last one, why none can be started (empty: it can), and what would be
    /// done.
    void showState(const std::optional<thunderbots::SweepProgress>& sweep, const QString& reason,
                   const QString& outlook);

  signals:
    void startAsked();
    void stopAsked();
    /// A setting has changed.
    void edited();

  private:
    SignedSpinBox* addNumber(const char* name, const QString& label, int lowest, int highest, int value);
    void addField(QWidget* field, const char* name, const QString& label);
    void makeButtons();
    void watch(SignedSpinBox* field, bool grid);

    QSettings& settings_;
    int fields_ = 0;
    QComboBox* solenoid_;
    SignedSpinBox* from_ = nullptr;
    SignedSpinBox* to_ = nullptr;
    SignedSpinBox* step_ = nullptr;
    SignedSpinBox* count_ = nullptr;
    SignedSpinBox* pause_ = nullptr;
    QWidget* buttons_;
    QPushButton* start_;
    QPushButton* stop_;
    QLabel* progress_;
};

}  // namespace kickstand::ui
