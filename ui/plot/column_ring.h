#pragma once

#include <array>

#include "ui/plot/columns.h"

namespace kickstand::ui {

/// Which columns a ring of so many places holds, and which have to be drawn when another span is to be seen.
/// Only the bookkeeping: the pixels are SpanImage's.
class ColumnRing {
  public:
    /// A run of columns that lie side by side in the ring too.
    struct Piece {
        int place = 0;  ///< Of its first column.
        std::int64_t first = 0;
        int count = 0;
    };

    /// Forgets everything; from now on there is room for `places` columns.
    void reset(int places);
    int places() const { return places_; }

    /// `wanted`, no more columns than there are places, is to be seen. Columns from `present` on lie in the
    /// future and are not drawn; those from `settled` on may still change and are drawn again next time.
    /// Gives what is to be drawn now: one span on either side of what is there.
    std::array<ColumnSpan, 2> show(ColumnSpan wanted, std::int64_t settled, std::int64_t present);

    /// The place of a column.
    int placeOf(std::int64_t column) const;
    /// A span of at most places() columns as it lies in the ring: at most two pieces, of which the second may
    /// be empty.
    std::array<Piece, 2> piecesOf(ColumnSpan span) const;

  private:
    int places_ = 0;
    ColumnSpan drawn_;  ///< Those that need not be drawn again.
};

}  // namespace kickstand::ui
