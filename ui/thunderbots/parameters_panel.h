#pragma once

#include <QTimer>
#include <array>

#include "core/thunderbots/commands.h"
#include "core/thunderbots/parameter_draft.h"
#include "core/thunderbots/snapshot.h"
#include "ui/shell/panel.h"

class QAction;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedLayout;

namespace kickstand {
class Ledger;
enum class ParameterStep;
struct ParameterRecord;
}  // namespace kickstand

namespace kickstand::ui {

class ParametersGrid;
class ParametersHistory;
class RobotChoice;
class Segmented;
class StateLabel;

/// A robot's operational parameters: read, edited as a draft beside a file or an earlier reading, applied
/// until the next reboot, committed for good, and proven by a reboot. Each robot has a draft of its own.
class ParametersPanel final : public Panel {
    Q_OBJECT
  public:
    /// `ledger` keeps every reading; it outlives the panel.
    ParametersPanel(Bench& bench, RobotChoice& choice, Ledger& ledger, QWidget* parent = nullptr);

    QWidget* headerTools() override;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    /// What stands in the third column.
    struct Other {
        thunderbots::ParameterValues values;
        QString title;
    };

    QWidget* makeDraft();
    QWidget* makeSteps();
    void addEdits(QHBoxLayout& row);
    void connectAll();
    void refresh();
    void takeReadings(const thunderbots::Snapshot* snapshot);
    void showState(const thunderbots::Snapshot* snapshot);
    void showSteps(const thunderbots::Snapshot* snapshot);
    void showEdits();
    void showNotice(const thunderbots::Snapshot* snapshot, const QString& reason);
    void forgetDrafts();
    void showPage(int page);

    void read();
    void apply();
    void commit();
    void reboot();
    void ask(const thunderbots::Command& command);
    void askFirst(ParameterStep step, const thunderbots::wire::OperationalParameters& block,
                  const thunderbots::Command& command);

    void openFile();
    void readFile(const QString& path);
    void saveFile();
    void showOther(const thunderbots::ParameterValues& values, const QString& title);
    /// The values of the reading that is selected; says so where it has none.
    std::optional<thunderbots::ParameterValues> selectedValues();
    void compare();
    void restore();
    void editNote();

    thunderbots::ParameterDraft& draft() { return drafts_[static_cast<std::size_t>(robot_)]; }
    Other& other() { return others_[static_cast<std::size_t>(robot_)]; }

    RobotChoice& choice_;
    Ledger& ledger_;
    ParametersGrid* grid_;
    ParametersHistory* history_;
    QStackedLayout* pages_;
    Segmented* page_;
    StateLabel* state_;
    QLabel* notice_;
    QPushButton* read_;
    QPushButton* apply_;
    QPushButton* commit_;
    QPushButton* reboot_;
    QAction* undo_;
    QAction* redo_;
    QAction* reset_;
    std::array<thunderbots::ParameterDraft, thunderbots::kRobots> drafts_;
    std::array<Other, thunderbots::kRobots> others_;
    int robot_ = 0;   ///< The one that is shown.
    int chosen_ = 0;  ///< How many are chosen.
    QString refusal_;
    QTimer looks_;
};

}  // namespace kickstand::ui
