#pragma once

#include <algorithm>
#include <vector>

#include "core/base/bytes.h"

namespace kickstand::sim {

/// Cuts what comes over a connection into lines, none longer than was agreed: of a longer one only the bound
/// is ever kept. A carriage return before the end of a line belongs to the end.
class LineReader {
  public:
    explicit LineReader(std::size_t longest) : longest_(longest) {}

    /// Calls `line(ByteView)` for each line that ends in `bytes`, without its end, and `tooLong()` for each
    /// that had no room.
    template <class Line, class TooLong>
    void take(ByteView bytes, Line line, TooLong tooLong) {
        while (!bytes.empty()) {
            const auto end = std::find(bytes.begin(), bytes.end(), std::uint8_t{'\n'});
            const auto length = static_cast<std::size_t>(end - bytes.begin());
            keep(bytes.first(length));
            if (end == bytes.end()) return;
            bytes = bytes.subspan(length + 1);
            if (overflowed_) {
                tooLong();
            } else {
                if (!kept_.empty() && kept_.back() == '\r') kept_.pop_back();
                line(ByteView(kept_));
            }
            kept_.clear();
            overflowed_ = false;
        }
    }

  private:
    void keep(ByteView piece) {
        if (piece.size() > longest_ - kept_.size()) overflowed_ = true;
        if (!overflowed_) kept_.insert(kept_.end(), piece.begin(), piece.end());
    }

    const std::size_t longest_;
    std::vector<std::uint8_t> kept_;
    bool overflowed_ = false;
};

}  // namespace kickstand::sim
