#include "ui/smartdevice/plot_choice.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QSettings>
#include <QSignalBlocker>
#include <algorithm>
#include <limits>

#include "ui/plot/curve_colours.h"
#include "ui/smartdevice/device_choice.h"
#include "ui/smartdevice/device_words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

constexpr const char* kSetting = "smartdevice/plotted";
constexpr int kValueColumn = 1;
constexpr int kValueWidth = 88;
constexpr int kLetters = 26;
constexpr int kMark = 14;
/// So many curves are shown before anybody has chosen: one of each board.
constexpr std::size_t kFirstCurves = 3;

QString keyOf(const DeviceState& device, const ParameterSpec& spec) {
    return QString::fromStdString(wire::toText(device.uid) + '/' + spec.name);
}

/// "A" to "Z", then "A2".
QString letterOf(std::size_t curve) {
    const auto at = static_cast<int>(curve);
    QString letter(QChar(u'A' + static_cast<char16_t>(at % kLetters)));
    if (at >= kLetters) letter += QString::number(at / kLetters + 1);
    return letter;
}

bool isPlotted(const ParameterSpec& spec) {
    return spec.readable() && spec.type != wire::ValueType::Raw;
}

/// What may share an area: one unit, or one range where there is none.
PlotArea areaOf(const ParameterSpec& spec) {
    PlotArea area;
    area.unit = QString::fromStdString(spec.unit);
    area.decimals = decimalsOf(spec);
    const double least = spec.lowest.value_or(0);
    area.usual = {least, std::max(spec.highest.value_or(least + 1), least + 1)};
    if (spec.type == wire::ValueType::Bool) {
        area.title = PlotChoice::tr("on or off");
        area.usual = {-0.1, 1.1};
    } else if (!area.unit.isEmpty()) {
        area.title = area.unit;
    } else if (spec.lowest && spec.highest) {
        area.title =
            PlotChoice::tr("%1 to %2").arg(numberText(*spec.lowest, 0), numberText(*spec.highest, 0));
    } else {
        area.title = QString::fromStdString(spec.name);
    }
    return area;
}

QIcon markOf(const QString& letter, int colour, bool dark) {
    QPixmap picture(kMark, kMark);
    const QColor fill = curveColour(colour, dark);
    picture.fill(fill);
    QPainter painter(&picture);
    painter.setPen(fill.lightnessF() > 0.5F ? Qt::black : Qt::white);
    painter.setFont(textFont(metrics::kSmallTextSize, QFont::DemiBold));
    painter.drawText(picture.rect(), Qt::AlignCenter, letter);
    return picture;
}

}  // namespace

PlotChoice::PlotChoice(QSettings& settings, QWidget* parent) : QTreeWidget(parent), settings_(settings) {
    setObjectName(QStringLiteral("boardPlotTree"));
    setAccessibleName(tr("Parameters that are plotted"));
    setColumnCount(2);
    setHeaderHidden(true);
    setFrameShape(QFrame::NoFrame);
    setIndentation(12);
    setUniformRowHeights(true);
    setIconSize({kMark, kMark});
    viewport()->setAutoFillBackground(false);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(40);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(kValueColumn, QHeaderView::Fixed);
    header()->resizeSection(kValueColumn, kValueWidth);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem*, int column) {
        if (column == 0) keep();
    });
}

QString PlotChoice::shapeOf(const Snapshot& snapshot) const {
    QString shape;
    for (const DeviceState& device : snapshot.devices)
        shape += titleOf(settings_, device) + u'/' + QString::fromStdString(wire::toText(device.uid)) + u'/' +
                 QString::number(device.parameters.size()) + u'\n';
    return shape;
}

void PlotChoice::addBoard(const DeviceState& device) {
    const QStringList chosen = settings_.value(kSetting).toStringList();
    auto* board = new QTreeWidgetItem(this, {titleOf(settings_, device), {}});
    board->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    board->setFont(0, textFont(metrics::kTextSize, QFont::DemiBold));
    for (std::size_t i = 0; i < device.spec->parameters.size(); ++i) {
        const ParameterSpec& spec = device.spec->parameters[i];
        if (!isPlotted(spec)) continue;
        auto* item = new QTreeWidgetItem(board, {QString::fromStdString(spec.name), {}});
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setFont(kValueColumn, numberFont(metrics::kSmallTextSize));
        item->setTextAlignment(kValueColumn, Qt::AlignRight | Qt::AlignVCenter);
        const QString key = keyOf(device, spec);
        item->setCheckState(0, chosen.contains(key) ? Qt::Checked : Qt::Unchecked);
        rows_.push_back({device.number, static_cast<int>(i), key, item});
    }
    board->setExpanded(true);
}

void PlotChoice::chooseFirst(const Snapshot& snapshot) {
    if (settings_.contains(kSetting)) return;
    std::size_t curves = 0;
    int last = -1;
    for (const Row& row : rows_) {
        const ParameterSpec& spec = snapshot.devices[static_cast<std::size_t>(row.device)]
                                        .spec->parameters[static_cast<std::size_t>(row.parameter)];
        if (row.device == last || spec.type == wire::ValueType::Bool || curves == kFirstCurves) continue;
        row.item->setCheckState(0, Qt::Checked);
        last = row.device;
        ++curves;
    }
}

void PlotChoice::rebuild(const Snapshot& snapshot) {
    const QSignalBlocker quiet(this);
    clear();
    rows_.clear();
    for (const DeviceState& device : snapshot.devices)
        addBoard(device);
    chooseFirst(snapshot);
    dirty_ = true;
}

void PlotChoice::keep() {
    QStringList chosen = settings_.value(kSetting).toStringList();
    for (const Row& row : rows_) {
        chosen.removeAll(row.key);
        if (row.item->checkState(0) == Qt::Checked) chosen << row.key;
    }
    settings_.setValue(kSetting, chosen);
    dirty_ = true;
    emit changed();
}

void PlotChoice::refreshContents(const Snapshot& snapshot) {
    contents_ = {};
    for (const Row& row : rows_) {
        if (row.item->checkState(0) != Qt::Checked) continue;
        const DeviceState& device = snapshot.devices[static_cast<std::size_t>(row.device)];
        const ParameterSpec& spec = device.spec->parameters[static_cast<std::size_t>(row.parameter)];
        const PlotArea area = areaOf(spec);
        const auto found = std::ranges::find(contents_.areas, area.title, &PlotArea::title);
        const auto at = static_cast<int>(found - contents_.areas.begin());
        if (found == contents_.areas.end()) {
            contents_.areas.push_back(area);
        } else {
            found->usual.low = std::min(found->usual.low, area.usual.low);
            found->usual.high = std::max(found->usual.high, area.usual.high);
        }
        const std::size_t curve = contents_.curves.size();
        contents_.curves.push_back(
            {{static_cast<std::uint16_t>(row.device), static_cast<std::uint16_t>(row.parameter)},
             at,
             tr("%1 %2").arg(titleOf(settings_, device), QString::fromStdString(spec.name)),
             letterOf(curve),
             static_cast<int>(curve) % kCurveColours});
    }
    refreshMarks();
}

void PlotChoice::refreshMarks() {
    const QSignalBlocker quiet(this);
    const bool dark = tokensOf(palette()).dark;
    for (const Row& row : rows_) {
        const auto curve = std::ranges::find_if(contents_.curves, [&row](const PlotCurve& one) {
            return one.signal.unit == row.device && one.signal.signal == row.parameter;
        });
        row.item->setIcon(
            0, curve == contents_.curves.end() ? QIcon() : markOf(curve->tag, curve->colour, dark));
    }
    viewport()->update();
}

void PlotChoice::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) refreshMarks();
}

bool PlotChoice::follow(const Snapshot* snapshot, TimePoint now) {
    const Snapshot nothing;
    const Snapshot& there = snapshot == nullptr ? nothing : *snapshot;
    if (const QString shape = shapeOf(there); shape != shape_) {
        shape_ = shape;
        rebuild(there);
    }
    const bool different = std::exchange(dirty_, false);
    if (different) refreshContents(there);
    const QSignalBlocker quiet(this);
    bool drawn = false;
    for (const Row& row : rows_) {
        const DeviceState& device = there.devices[static_cast<std::size_t>(row.device)];
        const ParameterSpec& spec = device.spec->parameters[static_cast<std::size_t>(row.parameter)];
        const ParameterState& state = device.parameters[static_cast<std::size_t>(row.parameter)];
        QString text = state.value ? withUnit(valueText(*state.value, spec), spec) : QStringLiteral("\u2014");
        if (state.value && isOld(state, device, now)) text += u'?';
        if (row.item->text(kValueColumn) == text) continue;
        row.item->setText(kValueColumn, text);
        drawn = true;
    }
    if (drawn) viewport()->update();
    return different;
}

}  // namespace kickstand::ui
