#include "ui/smartdevice/device_list.h"

#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <utility>

#include "ui/smartdevice/device_icon.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kLineHeight = 60;
constexpr int kIcon = 28;
constexpr int kMargin = 8;
constexpr int kTone = 9;

/// All that is drawn, in words.
QString spoken(const DeviceLine& line) {
    QStringList words{line.title, line.place, line.standing.text, line.median, line.p99};
    words.removeAll(QString());
    return words.join(QStringLiteral(", "));
}

class LineDelegate final : public QStyledItemDelegate {
  public:
    explicit LineDelegate(DeviceList& list) : QStyledItemDelegate(&list), list_(list) {}

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {200, kLineHeight};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Tokens& t = tokensOf(option.palette);
        const DeviceLine& line = list_.lines()[static_cast<std::size_t>(index.row())];
        painter->save();
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        if (selected) {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->setPen(Qt::NoPen);
            painter->setBrush(t.accentSoft);
            painter->drawRoundedRect(option.rect.adjusted(2, 2, -2, -2), metrics::kControlRadius,
                                     metrics::kControlRadius);
        }
        const QRect area = option.rect.adjusted(kMargin, 0, -kMargin, 0);
        const QRectF icon(area.left(), area.center().y() - kIcon / 2.0, kIcon, kIcon);
        const bool gone = line.standing.tone == Tone::Danger || line.device < 0;
        const QColor ink = gone ? t.muted : selected ? t.accent : t.text;
        if (line.device < 0)
            drawPortIcon(*painter, icon, ink);
        else
            drawDeviceIcon(*painter, icon, line.kind.toStdString(), ink);
        const QRect text(area.left() + kIcon + 12, area.top() + 6, area.width() - kIcon - 12, 0);
        paintText(*painter, text, line, t, gone);
        painter->restore();
    }

  private:
    static void row(QPainter& painter, const QRect& place, const QString& left, const QColor& ink,
                    const QString& right, const QColor& rightInk, const QFont& font) {
        const QFont small = numberFont(metrics::kSmallTextSize);
        painter.setFont(small);
        const int taken = right.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(right) + kMargin;
        painter.setPen(rightInk);
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, right);
        painter.setFont(font);
        painter.setPen(ink);
        painter.drawText(
            place, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(left, Qt::ElideMiddle, std::max(0, place.width() - taken)));
    }

    static void paintText(QPainter& painter, QRect place, const DeviceLine& line, const Tokens& t,
                          bool gone) {
        place.setHeight(18);
        row(painter, place, line.title, gone ? t.muted : t.text, line.median, t.text,
            textFont(metrics::kTextSize, QFont::DemiBold));
        place.translate(0, 16);
        row(painter, place, line.place, t.muted, line.p99, t.muted, textFont(metrics::kSmallTextSize));
        place.translate(0, 16);
        const QColor colour = toneColour(line.standing.tone, t);
        drawTone(painter, line.standing.tone,
                 QRectF(place.left(), place.center().y() - kTone / 2.0 + 1, kTone, kTone), colour);
        row(painter, place.adjusted(kTone + 5, 0, 0, 0), line.standing.text, colour, {}, t.muted,
            textFont(metrics::kSmallTextSize));
    }

    DeviceList& list_;
};

}  // namespace

DeviceList::DeviceList(QWidget* parent) : QListWidget(parent) {
    setObjectName(QStringLiteral("boards"));
    setAccessibleName(tr("Boards and ports"));
    setItemDelegate(new LineDelegate(*this));
    setFrameShape(QFrame::NoFrame);
    setUniformItemSizes(true);
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(false);
    connect(this, &QListWidget::currentRowChanged, this, [this] {
        const DeviceLine* line = currentLine();
        if (line != nullptr && line->device >= 0) emit asked(line->device);
        emit currentLineChanged();
    });
}

void DeviceList::setLines(std::vector<DeviceLine> lines) {
    if (lines == lines_) return;
    const QSignalBlocker quiet(this);
    lines_ = std::move(lines);
    while (count() > static_cast<int>(lines_.size()))
        delete takeItem(count() - 1);
    while (count() < static_cast<int>(lines_.size()))
        new QListWidgetItem(this);
    for (int row = 0; row < count(); ++row) {
        const DeviceLine& line = lines_[static_cast<std::size_t>(row)];
        const QString words = spoken(line);
        if (item(row)->text() != words) item(row)->setText(words);
        item(row)->setToolTip(line.remedy.isEmpty() ? words : line.remedy);
    }
    viewport()->update();
}

void DeviceList::setChosen(int device) {
    const DeviceLine* now = currentLine();
    const bool same = std::exchange(chosen_, device) == device;
    // A port stays current while a person looks at it.
    if (now != nullptr && (now->device == device || (same && now->device < 0))) return;
    const QSignalBlocker quiet(this);
    for (int row = 0; row < count(); ++row) {
        if (lines_[static_cast<std::size_t>(row)].device == device && device >= 0) setCurrentRow(row);
    }
}

const DeviceLine* DeviceList::currentLine() const {
    const int row = currentRow();
    return row < 0 || row >= static_cast<int>(lines_.size()) ? nullptr
                                                             : &lines_[static_cast<std::size_t>(row)];
}

}  // namespace kickstand::ui
