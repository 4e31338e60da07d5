#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <array>
#include <vector>

#include "ui/thunderbots/voltages_contents.h"

namespace kickstand::ui {

/// One curve in numbers.
struct CurveLine {
    int colour = 0;
    QString tag;
    QString name;
    NowText now;
    std::array<QString, 3> values;  ///< Min, max, mean; or at A, at B, and from A to B.

    friend bool operator==(const CurveLine&, const CurveLine&) = default;
};

class CurveTableModel final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Name, Now, First, ColumnCount = First + 3 };
    enum Role { ColourRole = Qt::UserRole, TagRole, StaleRole, DangerRole };

    using QAbstractTableModel::QAbstractTableModel;

    /// With `cursors` the values are those at the cursors.
    void setLines(std::vector<CurveLine> lines, bool cursors);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    std::vector<CurveLine> lines_;
    bool cursors_ = false;
};

/// The legend of the plot: each curve with its colour and label, its value now, and what was asked about the
/// visible span.
class VoltagesTable final : public QTableView {
    Q_OBJECT
  public:
    explicit VoltagesTable(QWidget* parent = nullptr);

    CurveTableModel& lines() { return model_; }
    /// As plain text with tabs between the columns, to copy.
    QString text() const;

  private:
    CurveTableModel model_;
};

}  // namespace kickstand::ui
