#pragma once

#include <QSortFilterProxyModel>

#include "core/thunderbots/commands.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/choice_summary.h"
#include "ui/thunderbots/kick_rows.h"

class QLabel;
class QTableView;

namespace kickstand::ui {

class KickSettings;
class KickSweepBox;
class RobotChoice;

/// Every kick of the session with what it did to the capacitor, to sort, note, copy and save, and the sweep
/// that fills it.
class KickLogPanel final : public Panel {
    Q_OBJECT
  public:
    KickLogPanel(Bench& bench, RobotChoice& choice, KickSettings& kick, QWidget* parent = nullptr);

    QWidget* headerTools() override;
    /// Stops whatever moves, charges or is armed.
    void closed() override;

  private:
    void buildTable();
    void refresh();
    /// `snapshot`: of the shown session, or null.
    void takeRows(const thunderbots::Snapshot* snapshot);
    void showSweep(const thunderbots::Snapshot* snapshot);
    /// What a sweep would do, or why it cannot be.
    QString outlook(bool& possible) const;
    void startSweep();
    void copy();
    /// The rows that are selected, or all, in the order that is shown.
    std::vector<KickRow> wantedRows() const;
    void ask(const thunderbots::Command& command);

    RobotChoice& choice_;
    KickSettings& kick_;
    KickRows rows_;
    std::shared_ptr<const thunderbots::KickRecords> taken_;
    QSortFilterProxyModel sorted_;
    KickSweepBox* sweep_;
    QTableView* table_;
    QLabel* empty_;
    ChoiceSummary summary_;
    QString refusal_;
};

}  // namespace kickstand::ui
