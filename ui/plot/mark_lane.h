#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace kickstand::ui {

/// A mark that is to be told in the lane above the areas, in pixels.
struct LaneMark {
    double x = 0;
    int width = 0;            ///< Of its word.
    int kind = 0;             ///< Marks of one kind can be told together.
    bool urgent = false;      ///< Words of others make room for its own.
    std::uint64_t units = 0;  ///< A bit for the unit that it concerns.
};

/// Marks of a kind that are told together, or one alone.
struct LaneGroup {
    std::size_t mark = 0;  ///< The first one.
    int count = 1;
    std::uint64_t units = 0;  ///< Of all of them.
};

/// Where words may stand: rows are counted from the areas upwards. A word belongs to the line at which it
/// begins (or ends, at the right edge), which goes down from it through the rows below.
struct LaneRoom {
    double left = 0;
    double right = 0;     ///< Marks beyond are not seen.
    double wordsEnd = 0;  ///< Words may go on past the last mark.
    double topEnd = 0;    ///< In the top row something else begins here.
    int rows = 1;
};

/// A word in its row, at the line of the first of its marks.
struct LaneWord {
    LaneGroup group;
    double x = 0;  ///< Of the line.
    int row = 0;
    double left = 0;
    int width = 0;

    double right() const { return left + width; }
};

/// Where a mark is drawn.
struct LanePlace {
    std::size_t mark = 0;
    double x = 0;

    friend bool operator==(const LanePlace&, const LanePlace&) = default;
};

struct LaneLayout {
    std::vector<LaneWord> words;
    std::vector<LanePlace> lines;   ///< One for all marks of an instant.
    std::vector<LanePlace> glyphs;  ///< Shapes above the areas, none on another.
};

/// How wide the word is that tells several marks together.
using LaneCountWidth = std::function<int(const LaneGroup& group)>;

inline constexpr int kLaneGlyph = 7;
/// From a line to its word.
inline constexpr int kLaneIndent = 4;
/// Between words of one row.
inline constexpr int kLaneGap = 8;

/// Places words, lines and shapes of marks (by x, rising) so that nothing is drawn on anything. Marks of a
/// kind at the same instant are told together, and so are those that find no room beside one of their kind;
/// what still finds none has no word. Later marks move no word of earlier ones, unless they are urgent: marks
/// left of the room count as well, so that words do not jump as time goes on.
LaneLayout layOutLane(std::vector<LaneMark> marks, const LaneRoom& room, const LaneCountWidth& countWidth);

}  // namespace kickstand::ui
