#include "ui/plot/mark_painter.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "ui/plot/mark_looks.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

struct MarkText {
    Q_DECLARE_TR_FUNCTIONS(MarkText)
};

/// Words are placed from a column that is a multiple of this, left of what is seen: their places depend on
/// marks before them, and would change with every mark that leaves otherwise.
constexpr std::int64_t kAnchorColumns = 1024;
constexpr int kToGlyphMiddle = kLaneGlyph / 2;

std::uint64_t unitBit(std::uint16_t unit) {
    return unit == kNoUnit ? 0 : std::uint64_t{1} << unit % 64;
}

/// Of hundreds of marks only a few look different: each picture is looked for once.
class PictureOfLook {
  public:
    using Make = std::function<QPixmap(std::size_t mark)>;

    explicit PictureOfLook(Make make) : make_(std::move(make)) {}

    const QPixmap& of(std::size_t mark, int look) {
        QPixmap& picture = pictures_.at(static_cast<std::size_t>(look - kTriggerLook));
        if (picture.isNull()) picture = make_(mark);
        return picture;
    }

  private:
    Make make_;
    std::array<QPixmap, kLooks> pictures_;
};

QColor inkOf(MarkTone tone, const Tokens& t) {
    switch (tone) {
        case MarkTone::Plain:
            return t.text;
        case MarkTone::Warning:
            return t.warn;
        case MarkTone::Danger:
            return t.danger;
    }
    return t.text;
}

QString triggerLabel() {
    return MarkText::tr("trigger");
}

}  // namespace

MarkPainter::MarkPainter(const PlotState& state, const PlotGeometry& geometry, const Tokens& tokens,
                         const PlotFonts& fonts, DescribedMarks& marks, double topEnd)
    : state_(state), geometry_(geometry), t_(tokens), fonts_(fonts), marks_(marks) {
    if (geometry_.empty()) return;
    marks_.update(state_);
    collect(marks_);
    addTrigger();
    const QRect& area = geometry_.areas.front();
    const LaneRoom room{static_cast<double>(area.left()), static_cast<double>(area.right()),
                        geometry_.laneEnd(), topEnd, geometry_.laneRows};
    layout_ = layOutLane(lane_, room, [this](const LaneGroup& group) {
        const Told& first = told_[group.mark];
        return first.item == nullptr ? lane_[group.mark].width
                                     : marks_.together(state_, *first.item, group).width;
    });
}

void MarkPainter::collect(const DescribedMarks& marks) {
    const ColumnSpan shown = state_.view.shown();
    const std::int64_t anchor = (floorDivide(shown.first, kAnchorColumns) - 1) * kAnchorColumns;
    const auto seen = marks.between(startOf(anchor, state_.view.columnWidth()), state_.view.end());
    lane_.reserve(seen.size() + 1);
    told_.reserve(seen.size() + 1);
    for (const DescribedMarks::Item* item : seen) {
        const int look = lookOf(item->mark.kind);
        lane_.push_back({std::floor(geometry_.xOf(state_.view, item->mark.time)), item->width, look,
                         item->words.tone != MarkTone::Plain, unitBit(item->mark.unit)});
        told_.push_back({item, look, inkOf(item->words.tone, t_)});
    }
}

void MarkPainter::addTrigger() {
    if (!state_.trigger || state_.trigger->state != PlotTrigger::State::Caught) return;
    const double x = std::floor(geometry_.xOf(state_.view, state_.trigger->caughtAt));
    const auto next = std::find_if(lane_.begin(), lane_.end(), [x](const LaneMark& m) { return m.x > x; });
    const auto at = next - lane_.begin();
    lane_.insert(next, {x, textWidth(fonts_.text, triggerLabel(), 0), kTriggerLook, true, 0});
    told_.insert(told_.begin() + at, {nullptr, kTriggerLook, t_.accent});
}

QString MarkPainter::textOf(const LaneWord& word) const {
    const DescribedMarks::Item* item = told_[word.group.mark].item;
    if (item == nullptr) return triggerLabel();
    return word.group.count == 1 ? item->words.label : marks_.together(state_, *item, word.group).text;
}

void MarkPainter::paintLines(QPainter& painter) const {
    const double ratio = painter.device()->devicePixelRatioF();
    int height = 0;
    for (const QRect& area : geometry_.areas)
        height = std::max(height, area.height());
    PictureOfLook pictures([&](std::size_t mark) {
        const Told& told = told_[mark];
        return markLine(told.look, lane_[mark].urgent ? told.ink : t_.muted, height, ratio);
    });
    for (const LanePlace& line : layout_.lines) {
        const QPixmap& picture = pictures.of(line.mark, told_[line.mark].look);
        for (const QRect& area : geometry_.areas)
            painter.drawPixmap(QPointF(line.x, area.top()), picture,
                               QRectF(0, 0, ratio, area.height() * ratio));
    }
}

void MarkPainter::paintLane(QPainter& painter) const {
    const double ratio = painter.device()->devicePixelRatioF();
    painter.setFont(fonts_.text);
    for (const LaneWord& word : layout_.words) {
        const double top = geometry_.laneRowTop(word.row);
        const Told& told = told_[word.group.mark];
        // A word stands on its line like a flag on its pole.
        painter.fillRect(QRectF(word.x, top + 2, 1, geometry_.laneGlyphTop() - top - 2), t_.line);
        drawText(painter, QPointF(word.left, top), textOf(word), {told.ink, t_.surface, 0, kLaneRowHeight});
    }
    PictureOfLook pictures(
        [&](std::size_t mark) { return markGlyph(told_[mark].look, told_[mark].ink, ratio); });
    for (const LanePlace& glyph : layout_.glyphs)
        painter.drawPixmap(QPointF(glyph.x - kToGlyphMiddle, geometry_.laneGlyphTop()),
                           pictures.of(glyph.mark, told_[glyph.mark].look));
}

}  // namespace kickstand::ui
