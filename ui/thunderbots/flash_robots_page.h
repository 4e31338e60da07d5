#pragma once

#include <array>

#include "ui/thunderbots/flash_page.h"
#include "ui/thunderbots/flash_wizard_state.h"

class QCheckBox;

namespace kickstand::ui {

class StateLabel;

/// The wizard's first page: which robots, how they are, and what keeps one of them from being flashed, with
/// its remedy beside it.
class FlashRobotsPage final : public FlashPageView {
    Q_OBJECT
  public:
    explicit FlashRobotsPage(QWidget* parent = nullptr);

    /// `snapshot` may be null.
    void showState(const FlashWizardState& state, const thunderbots::Snapshot* snapshot);

  signals:
    void robotsAsked(thunderbots::RobotMask robots);
    void optionsAsked(const thunderbots::FlashOptions& options);
    void remedyAsked(int robot);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Row {
        QWidget* all = nullptr;
        QCheckBox* tick = nullptr;
        QLabel* battery = nullptr;
        QLabel* capacitor = nullptr;
        StateLabel* state = nullptr;
        QPushButton* remedy = nullptr;
    };

    void makeHead();
    Row makeRow(int robot);
    void makeOptions();
    void showRow(int robot, const FlashWizardState& state, const thunderbots::Snapshot& snapshot);
    void showVolts(int robot, const thunderbots::RobotState& known);
    void setLoud(QLabel& label, bool loud);
    /// Brings the first robot into view that holds the page, when it is another one than before.
    void revealHeld(const FlashWizardState& state, const thunderbots::Snapshot& snapshot);
    void showOptions(const FlashWizardState& state, const thunderbots::Snapshot* snapshot);

    std::array<Row, thunderbots::kRobots> rows_;
    QLabel* empty_ = nullptr;
    QPushButton* everyone_ = nullptr;
    QCheckBox* lowBattery_ = nullptr;
    QCheckBox* capacitorUnknown_ = nullptr;
    thunderbots::RobotMask ticked_ = 0;
    thunderbots::RobotMask loud_ = 0;  ///< Whose capacitor is live.
    int revealed_ = -1;
    thunderbots::RobotMask heard_ = 0;
    thunderbots::FlashOptions options_;
};

}  // namespace kickstand::ui
