#pragma once

#include <QFont>
#include <QString>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "ui/plot/mark_lane.h"
#include "ui/plot/plot_state.h"

namespace kickstand::ui {

/// The words of a store's marks, and how wide they are. Each is asked for once and not for every frame.
class DescribedMarks {
  public:
    struct Item {
        Mark mark;
        MarkWords words;
        int width = 0;  ///< Of its label, in pixels.
    };
    struct Together {
        QString text;
        int width = 0;
    };

    /// Words are others now, or their font.
    void forget(const QFont& font);
    /// Asks for those that have come since.
    void update(const PlotState& state);
    /// Those in [from, to), by time.
    std::vector<const Item*> between(TimePoint from, TimePoint to) const;
    /// Several of a kind, told together.
    const Together& together(const PlotState& state, const Item& first, const LaneGroup& group);

  private:
    QFont font_;
    std::weak_ptr<const TelemetryStore> store_;
    std::uint64_t next_ = 0;
    std::deque<Item> items_;
    std::map<std::tuple<MarkKind, int, int, std::uint16_t>, Together> together_;
};

}  // namespace kickstand::ui
