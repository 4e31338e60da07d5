#include "ui/plot/mark_lane.h"

#include <algorithm>
#include <cmath>

namespace kickstand::ui {

namespace {

/// Marks within so many pixels share a line.
constexpr double kSameLine = 2;
/// Marks of one kind within so many pixels share a word.
constexpr double kTogether = 4;
constexpr double kGlyphPitch = kLaneGlyph + 2;
/// No word is wider: what is farther left cannot be in the way.
constexpr double kWidest = 400;
/// Between a line and a word that it passes.
constexpr double kLineAir = 2;
/// What lies farther from a word is not told with it.
constexpr double kJoinReach = 120;

LaneGroup joined(LaneGroup group, const LaneGroup& other) {
    group.count += other.count;
    group.units |= other.units;
    return group;
}

std::vector<LaneGroup> groupsOf(const std::vector<LaneMark>& marks) {
    std::vector<LaneGroup> groups;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const auto same = std::find_if(groups.rbegin(), groups.rend(), [&](const LaneGroup& group) {
            const LaneMark& first = marks[group.mark];
            return marks[i].x - first.x > kTogether || first.kind == marks[i].kind;
        });
        if (same != groups.rend() && marks[i].x - marks[same->mark].x <= kTogether) {
            *same = joined(*same, {i, 1, marks[i].units});
        } else {
            groups.push_back({i, 1, marks[i].units});
        }
    }
    return groups;
}

/// Where the lines of marks stand that are so near to each other that they share one.
void shareLines(std::vector<LaneMark>& marks) {
    for (std::size_t i = 1; i < marks.size(); ++i) {
        if (marks[i].x - marks[i - 1].x <= kSameLine) marks[i].x = marks[i - 1].x;
    }
}

class WordPlacer {
  public:
    WordPlacer(const std::vector<LaneMark>& marks, const LaneRoom& room, const LaneCountWidth& countWidth)
        : marks_(marks), room_(room), countWidth_(countWidth) {}

    void add(const LaneGroup& group) {
        const int width = widthOf(group);
        if (place(group, width)) return;
        if (marks_[group.mark].urgent && placeInsteadOfOthers(group, width)) return;
        join(group);
    }
    std::vector<LaneWord> words() && { return std::move(words_); }

  private:
    int widthOf(const LaneGroup& group) const {
        return group.count == 1 ? marks_[group.mark].width : countWidth_(group);
    }
    /// A word at its line in a row: to the right of it, or to the left where the room ends.
    LaneWord wordAt(const LaneGroup& group, int width, int row) const {
        const double x = marks_[group.mark].x;
        const double end = row + 1 == room_.rows ? room_.topEnd : room_.wordsEnd;
        const bool fits = x + kLaneIndent + width <= end;
        // What begins past the end of its row would end before it: that is no place for it.
        const double left = fits || x > end ? x + kLaneIndent : x - kLaneIndent - width;
        return {group, x, row, left, width};
    }

    bool inRoom(const LaneWord& word) const {
        const double end = word.row + 1 == room_.rows ? room_.topEnd : room_.wordsEnd;
        if (word.right() > end) return false;
        // Those of lines that are not seen only keep their places.
        return word.x < room_.left || word.left >= room_.left;
    }

    bool isFree(const LaneWord& word) const {
        if (!inRoom(word)) return false;
        for (auto other = words_.rbegin(); other != words_.rend(); ++other) {
            if (other->x + kWidest < word.left) break;
            if (other->row == word.row) {
                if (other->left < word.right() + kLaneGap && word.left < other->right() + kLaneGap)
                    return false;
                continue;
            }
            // The line of the upper one passes the lower one.
            const LaneWord& lower = other->row < word.row ? *other : word;
            const double passing = other->row < word.row ? word.x : other->x;
            if (passing > lower.left - kLineAir && passing < lower.right() + kLineAir) return false;
        }
        return true;
    }

    bool place(const LaneGroup& group, int width) {
        for (int row = room_.rows - 1; row >= 0; --row) {
            const LaneWord word = wordAt(group, width, row);
            if (!isFree(word)) continue;
            words_.push_back(word);
            return true;
        }
        return false;
    }

    bool placeInsteadOfOthers(const LaneGroup& group, int width) {
        const std::vector<LaneWord> before = words_;
        for (std::size_t i = words_.size(); i-- > 0;) {
            if (words_[i].x + kWidest < marks_[group.mark].x) break;
            if (marks_[words_[i].group.mark].urgent) continue;
            words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(i));
            if (place(group, width)) return true;
        }
        words_ = before;
        return false;
    }

    /// Lets the last word of its kind tell of it too, where that is still near.
    void join(const LaneGroup& group) {
        for (std::size_t i = words_.size(); i-- > 0;) {
            if (words_[i].x + kJoinReach < marks_[group.mark].x) return;
            if (marks_[words_[i].group.mark].kind != marks_[group.mark].kind) continue;
            const LaneWord before = words_[i];
            words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(i));
            const LaneGroup all = joined(before.group, group);
            LaneWord after = wordAt(all, widthOf(all), before.row);
            if (!isFree(after)) after = before;
            words_.insert(words_.begin() + static_cast<std::ptrdiff_t>(i), after);
            return;
        }
    }

    const std::vector<LaneMark>& marks_;
    const LaneRoom& room_;
    const LaneCountWidth& countWidth_;
    std::vector<LaneWord> words_;
};

/// One at a place, an urgent one where there is one.
std::vector<LanePlace> linesOf(const std::vector<LaneMark>& marks, const std::vector<LaneGroup>& groups) {
    std::vector<LanePlace> lines;
    for (const LaneGroup& group : groups) {
        const LaneMark& mark = marks[group.mark];
        if (lines.empty() || lines.back().x != mark.x) {
            lines.push_back({group.mark, mark.x});
        } else if (mark.urgent && !marks[lines.back().mark].urgent) {
            lines.back().mark = group.mark;
        }
    }
    return lines;
}

/// Those of urgent marks first, the others between them.
std::vector<LanePlace> glyphsOf(const std::vector<LaneMark>& marks, const std::vector<LanePlace>& lines) {
    std::vector<LanePlace> urgent;
    for (const LanePlace& line : lines) {
        const bool free = urgent.empty() || line.x - urgent.back().x >= kGlyphPitch;
        if (free && marks[line.mark].urgent) urgent.push_back(line);
    }
    std::vector<LanePlace> glyphs;
    auto next = urgent.begin();
    for (const LanePlace& line : lines) {
        if (next != urgent.end() && *next == line) {
            glyphs.push_back(*next++);
            continue;
        }
        const bool before = glyphs.empty() || line.x - glyphs.back().x >= kGlyphPitch;
        const bool after = next == urgent.end() || next->x - line.x >= kGlyphPitch;
        if (before && after && !marks[line.mark].urgent) glyphs.push_back(line);
    }
    return glyphs;
}

}  // namespace

LaneLayout layOutLane(std::vector<LaneMark> marks, const LaneRoom& room, const LaneCountWidth& countWidth) {
    shareLines(marks);
    const std::vector<LaneGroup> groups = groupsOf(marks);
    WordPlacer placer(marks, room, countWidth);
    for (const LaneGroup& group : groups)
        placer.add(group);
    LaneLayout layout{std::move(placer).words(), linesOf(marks, groups), {}};
    layout.glyphs = glyphsOf(marks, layout.lines);
    const auto unseen = [&](const auto& place) { return place.x < room.left || place.x > room.right; };
    std::erase_if(layout.words, unseen);
    std::erase_if(layout.lines, unseen);
    std::erase_if(layout.glyphs, unseen);
    return layout;
}

}  // namespace kickstand::ui
