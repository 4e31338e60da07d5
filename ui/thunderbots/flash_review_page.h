#pragma once

#include <array>

#include "ui/thunderbots/flash_page.h"
#include "ui/thunderbots/flash_wizard_state.h"

class QCheckBox;

namespace kickstand::ui {

/// The wizard's third page: what each robot has beside what it is to get, what will happen in which order,
/// and how long it takes.
class FlashReviewPage final : public FlashPageView {
    Q_OBJECT
  public:
    explicit FlashReviewPage(QWidget* parent = nullptr);

    void showState(const FlashWizardState& state);

  signals:
    void leaveOutAsked(int robot, bool leaveOut);
    /// What robots did not tell is to be asked again.
    void readAsked();

  private:
    struct Row {
        QWidget* all = nullptr;
        QLabel* signature = nullptr;
        QCheckBox* leaveOut = nullptr;
    };
    Row makeRow(int robot);

    std::array<Row, thunderbots::kRobots> rows_;
    QLabel* summary_;
    QLabel* order_;
    QLabel* notice_;
    QPushButton* read_;
};

}  // namespace kickstand::ui
