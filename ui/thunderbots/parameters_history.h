#pragma once

#include <QWidget>
#include <optional>

#include "core/ledger/parameter_record.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace kickstand::ui {

/// The readings that the ledger keeps, newest first: to compare with, to restore and to write notes to.
class ParametersHistory final : public QWidget {
    Q_OBJECT
  public:
    explicit ParametersHistory(QWidget* parent = nullptr);

    /// Shows the readings of one robot number, or of all with -1.
    void showView(const LedgerView& view, int robot);
    /// The one that is selected.
    const ParameterRecord* selected() const;

  signals:
    void compareAsked();
    void restoreAsked();
    /// A note for the selected one.
    void noteAsked();

  private:
    void fill();
    void refreshButtons();

    QTreeWidget* list_;
    QLabel* state_;
    QPushButton* compare_;
    QPushButton* restore_;
    QPushButton* note_;
    LedgerView view_;
    int robot_ = -1;
};

/// "24 Jun, 12:04".
QString recordTime(const ParameterRecord& record);

}  // namespace kickstand::ui
