#include "ui/plot/described_marks.h"

#include <QFontMetrics>
#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace kickstand::ui {

namespace {

/// Far more than a plot has room for at once.
constexpr std::size_t kMostTogether = 512;

}  // namespace

void DescribedMarks::forget(const QFont& font) {
    font_ = font;
    next_ = 0;
    items_.clear();
    together_.clear();
}

void DescribedMarks::update(const PlotState& state) {
    if (store_.lock() != state.store) {
        store_ = state.store;
        forget(font_);
    }
    if (state.store == nullptr || !state.describeMark) return;
    const Marks& marks = state.store->marks();
    const QFontMetrics metrics(font_);
    std::array<Mark, 64> some;
    while (next_ < marks.total()) {
        const RingCopy copied = marks.copy(next_, some);
        if (copied.count == 0 && copied.next <= next_) break;
        next_ = copied.next;
        for (const Mark& mark : std::span(some).first(copied.count)) {
            if (auto words = state.describeMark(mark)) {
                const int width = metrics.horizontalAdvance(words->label);
                items_.push_back({mark, *std::move(words), width});
            }
        }
    }
    while (items_.size() > marks.capacity())
        items_.pop_front();
}

std::vector<const DescribedMarks::Item*> DescribedMarks::between(TimePoint from, TimePoint to) const {
    const auto before = [](const Item& item, TimePoint time) { return item.mark.time < time; };
    const auto first = std::lower_bound(items_.begin(), items_.end(), from, before);
    const auto end = std::lower_bound(first, items_.end(), to, before);
    std::vector<const Item*> found;
    found.reserve(static_cast<std::size_t>(end - first));
    std::transform(first, end, std::back_inserter(found), [](const Item& item) { return &item; });
    return found;
}

const DescribedMarks::Together& DescribedMarks::together(const PlotState& state, const Item& first,
                                                         const LaneGroup& group) {
    // Counts change with what is seen: those of views that are gone are asked for again.
    if (together_.size() >= kMostTogether) together_.clear();
    const MarkCount told{first.mark.kind, group.count, std::popcount(group.units), first.mark.unit};
    const auto [place, isNew] =
        together_.try_emplace({told.kind, told.count, told.units, told.units == 1 ? told.unit : kNoUnit});
    Together& together = place->second;
    if (isNew) {
        together.text = state.countMarks
                            ? state.countMarks(told)
                            : QStringLiteral("%1 \u00d7%2").arg(first.words.label).arg(told.count);
        together.width = QFontMetrics(font_).horizontalAdvance(together.text);
    }
    return together;
}

}  // namespace kickstand::ui
