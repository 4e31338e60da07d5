#pragma once

#include <QSortFilterProxyModel>

#include "core/engine/messages.h"
#include "ui/shell/panel.h"
#include "ui/thunderbots/faults_model.h"

class QComboBox;
class QLineEdit;
class QTableView;

namespace kickstand::ui {

/// Both tables of fault codes, to be searched; an event with a code leads here (Bench::goTo()).
class FaultsPanel final : public Panel {
    Q_OBJECT
  public:
    explicit FaultsPanel(Bench& bench, QWidget* parent = nullptr);

    /// The place of a code of the dongle's, as Bench::goTo() takes it.
    static QString placeOf(std::uint8_t dongleCode);

    QWidget* headerTools() override;
    void showDetail(const QString& detail) override;

  private:
    void buildView();
    void noteEvents(const std::vector<EngineEvent>& events);

    FaultsModel model_;
    QSortFilterProxyModel filter_;
    QSortFilterProxyModel tables_;  ///< One table of the two, in front of the search.
    QTableView* view_;
    QLineEdit* search_ = nullptr;
    QComboBox* table_ = nullptr;
};

}  // namespace kickstand::ui
