#include "core/telemetry/value_pyramid.h"

#include <utility>

namespace kickstand {

ValuePyramid::ValuePyramid(std::size_t cells) : values_(cells) {
    growing_.fill(Extremes::none());
    for (std::size_t nodes = cells / kFan; nodes >= kFan && levels_.size() < kMaxLevels; nodes /= kFan)
        levels_.emplace_back(nodes);
}

std::size_t ValuePyramid::bytes() const {
    std::size_t sum = values_.bytes();
    for (const auto& level : levels_)
        sum += level.bytes();
    return sum;
}

void ValuePyramid::append(std::uint64_t index, float value) {
    values_.store(index, value);
    Extremes finished = Extremes::none();
    finished.add(value);
    for (std::size_t level = 0; level < levels_.size(); ++level) {
        Extremes& node = growing_[level];
        node.add(finished);
        if ((index + 1) % kFan != 0) return;
        index /= kFan;
        levels_[level].store(index, node);
        finished = std::exchange(node, Extremes::none());
    }
}

// Climbs from both ends of the stretch: on each level at most seven nodes a side stick out of what the next
// level covers. A node whose values are all published is itself complete.
Extremes ValuePyramid::extremes(std::uint64_t first, std::uint64_t end) const {
    Extremes result = Extremes::none();
    for (; first < end && first % kFan != 0; ++first)
        result.add(values_.load(first));
    for (; first < end && end % kFan != 0; --end)
        result.add(values_.load(end - 1));
    for (std::size_t level = 0; level < levels_.size() && first < end; ++level) {
        first /= kFan;
        end /= kFan;
        const bool top = level + 1 == levels_.size();
        const RingCells<Extremes>& nodes = levels_[level];
        for (; first < end && (top || first % kFan != 0); ++first)
            result.add(nodes.load(first));
        for (; first < end && end % kFan != 0; --end)
            result.add(nodes.load(end - 1));
    }
    return result;
}

}  // namespace kickstand
