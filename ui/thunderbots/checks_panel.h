#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/checks_rows.h"
#include "ui/thunderbots/choice_summary.h"

class QLabel;
class QLayout;
class QPushButton;
class QTableView;

namespace kickstand::ui {

class ChecksSettingsBox;
class RobotChoice;

/// Checks the chosen robots, one after another: asks what a person has to see, lists every step with its
/// limit, value and verdict, and keeps the report.
class ChecksPanel final : public Panel {
    Q_OBJECT
  public:
    ChecksPanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

    QWidget* headerTools() override;
    /// Ends a check that runs.
    void closed() override;

  private:
    QWidget* makeControls();
    QWidget* makeQuestion();
    QLayout* makeRight();
    void buildTable();
    void connectAll();
    void refresh();
    void showControls(const thunderbots::Snapshot* snapshot);
    void showQuestion();
    QString reasonNotToStart(const thunderbots::Snapshot* snapshot) const;
    void start();
    void answer(thunderbots::CheckAnswer answer);
    void ask(const thunderbots::Command& command);
    const thunderbots::CheckProgress& check() const { return *check_; }

    RobotChoice& choice_;
    ChoiceSummary summary_;
    std::shared_ptr<const thunderbots::CheckProgress> check_ =
        std::make_shared<const thunderbots::CheckProgress>();
    ChecksRows rows_;
    ChecksSettingsBox* settings_;
    QPushButton* arm_ = nullptr;
    QPushButton* start_ = nullptr;
    QPushButton* stop_ = nullptr;
    QLabel* words_ = nullptr;
    std::array<QPushButton*, 4> answers_{};  ///< In the order of CheckAnswer.
    QLabel* notice_ = nullptr;
    QTableView* table_;
    QPushButton* report_ = nullptr;
    QString refusal_;
    int shownRow_ = -1;
    std::optional<std::size_t> answered_;  ///< The row whose question has its answer, which is on its way.
};

}  // namespace kickstand::ui
