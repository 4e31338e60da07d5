#include "ui/thunderbots/voltages_table.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>

#include "ui/plot/curve_colours.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kRowHeight = 20;
constexpr int kTagWidth = 20;
constexpr int kNameWidth = 112;
constexpr int kNowWidth = 68;
constexpr int kValueWidth = 48;
constexpr int kFontSize = 12;

class CurveDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Tokens& t = tokensOf(option.palette);
        painter->save();
        if (option.state.testFlag(QStyle::State_Selected)) painter->fillRect(option.rect, t.accentSoft);
        QRect area = option.rect.adjusted(4, 0, -4, 0);
        painter->setFont(option.font);
        if (index.column() == CurveTableModel::Name) {
            const QColor colour = curveColour(index.data(CurveTableModel::ColourRole).toInt(), t.dark);
            const QRect tag(area.left(), area.center().y() - 6, kTagWidth, 13);
            painter->fillRect(tag, colour);
            painter->setPen(colour.lightnessF() > 0.5F ? Qt::black : Qt::white);
            QFont strong = option.font;
            strong.setPixelSize(metrics::kSmallTextSize);
            strong.setWeight(QFont::DemiBold);
            painter->setFont(strong);
            painter->drawText(tag, Qt::AlignCenter, index.data(CurveTableModel::TagRole).toString());
            painter->setFont(option.font);
            area.setLeft(tag.right() + 7);
        }
        const bool danger = index.data(CurveTableModel::DangerRole).toBool();
        const bool stale = index.data(CurveTableModel::StaleRole).toBool();
        painter->setPen(danger ? t.danger : stale ? t.muted : t.text);
        const int align = index.column() == CurveTableModel::Name ? Qt::AlignLeft : Qt::AlignRight;
        painter->drawText(
            area, align | Qt::AlignVCenter | Qt::TextSingleLine,
            option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, area.width()));
        painter->restore();
    }
};

/// Quiet words over the columns.
class CurveHeader final : public QHeaderView {
  public:
    explicit CurveHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
        setFont(textFont(metrics::kSmallTextSize));
        setSectionResizeMode(QHeaderView::Fixed);
        setMinimumSectionSize(10);
        setStretchLastSection(true);
        setFixedHeight(kRowHeight);
    }

  protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override {
        const Tokens& t = tokensOf(palette());
        painter->save();
        painter->fillRect(rect, t.surface);
        painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1), t.grid);
        painter->setFont(font());
        painter->setPen(t.muted);
        const auto align = model()->headerData(section, orientation(), Qt::TextAlignmentRole).toInt();
        painter->drawText(rect.adjusted(4, 0, -4, 0), align,
                          model()->headerData(section, orientation()).toString());
        painter->restore();
    }
};

}  // namespace

void CurveTableModel::setLines(std::vector<CurveLine> lines, bool cursors) {
    if (cursors != cursors_) {
        cursors_ = cursors;
        emit headerDataChanged(Qt::Horizontal, First, ColumnCount - 1);
    }
    if (lines.size() != lines_.size()) {
        beginResetModel();
        lines_ = std::move(lines);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i] == lines_[i]) continue;
        lines_[i] = std::move(lines[i]);
        const auto row = static_cast<int>(i);
        emit dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

int CurveTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int CurveTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant CurveTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const CurveLine& line = lines_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            if (index.column() == Name) return line.name;
            if (index.column() == Now) return line.now.text;
            return line.values[static_cast<std::size_t>(index.column() - First)];
        case Qt::ToolTipRole:
            if (line.now.danger && line.now.stale) return tr("Not heard any more: treat as live.");
            if (line.now.stale) return tr("Not heard any more: the last value.");
            return {};
        case ColourRole:
            return line.colour;
        case TagRole:
            return line.tag;
        case StaleRole:
            return index.column() == Now && line.now.stale;
        case DangerRole:
            return index.column() == Now && line.now.danger;
        default:
            return {};
    }
}

QVariant CurveTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((section == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section >= First)
        return cursors_ ? tr("At the cursors, and from the first to the second")
                        : tr("Of the visible span; the mean is weighted by time");
    if (role != Qt::DisplayRole) return {};
    const std::array<QString, ColumnCount> titles =
        cursors_ ? std::array<QString, ColumnCount>{tr("Curve"), tr("Now"), tr("A"), tr("B"), tr("\u0394")}
                 : std::array<QString, ColumnCount>{tr("Curve"), tr("Now"), tr("Min"), tr("Max"), tr("Mean")};
    return titles[static_cast<std::size_t>(section)];
}

VoltagesTable::VoltagesTable(QWidget* parent) : QTableView(parent) {
    setObjectName(QStringLiteral("curveTable"));
    setAccessibleName(tr("Curves and their values"));
    setHorizontalHeader(new CurveHeader(this));
    setModel(&model_);
    setItemDelegate(new CurveDelegate(this));
    setFont(numberFont(kFontSize));
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(kRowHeight);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    int width = 0;
    for (int column = 0; column < CurveTableModel::ColumnCount; ++column) {
        const int wanted = column == CurveTableModel::Name  ? kNameWidth
                           : column == CurveTableModel::Now ? kNowWidth
                                                            : kValueWidth;
        setColumnWidth(column, wanted);
        width += wanted;
    }
    setFixedWidth(width + 12);
}

QString VoltagesTable::text() const {
    QStringList rows;
    for (int row = -1; row < model_.rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < CurveTableModel::ColumnCount; ++column) {
            cells << (row < 0 ? model_.headerData(column, Qt::Horizontal, Qt::DisplayRole)
                              : model_.data(model_.index(row, column), Qt::DisplayRole))
                         .toString();
        }
        rows << cells.join(u'\t');
    }
    return rows.join(u'\n');
}

}  // namespace kickstand::ui
