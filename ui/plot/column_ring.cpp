#include "ui/plot/column_ring.h"

namespace kickstand::ui {

void ColumnRing::reset(int places) {
    places_ = places;
    drawn_ = {};
}

std::array<ColumnSpan, 2> ColumnRing::show(ColumnSpan wanted, std::int64_t settled, std::int64_t present) {
    const ColumnSpan past = commonOf(wanted, {wanted.first, present});
    const ColumnSpan kept = commonOf(drawn_, past);
    drawn_ = commonOf(past, {past.first, settled});
    if (kept.empty()) return {past, ColumnSpan{}};
    return {ColumnSpan{past.first, kept.first}, ColumnSpan{kept.end, past.end}};
}

int ColumnRing::placeOf(std::int64_t column) const {
    return static_cast<int>(column - floorDivide(column, places_) * places_);
}

std::array<ColumnRing::Piece, 2> ColumnRing::piecesOf(ColumnSpan span) const {
    if (span.empty()) return {};
    const int place = placeOf(span.first);
    const auto count = static_cast<int>(std::min<std::int64_t>(span.count(), places_ - place));
    const auto rest = static_cast<int>(span.count() - count);
    return {Piece{place, span.first, count}, Piece{0, span.first + count, rest}};
}

}  // namespace kickstand::ui
