// Where the words of marks stand: beside their lines, and never on one another.

#include "ui/plot/mark_lane.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "ui/plot/name_places.h"

namespace kickstand::ui {
namespace {

constexpr int kWord = 60;
constexpr LaneRoom kRoom{100, 700, 740, 740, 2};

int countWidth(const LaneGroup&) {
    return 50;
}

std::vector<std::size_t> told(const LaneLayout& layout) {
    std::vector<std::size_t> marks;
    for (const LaneWord& word : layout.words)
        marks.push_back(word.group.mark);
    return marks;
}

/// All that the lane's rule is about: nothing on anything, all of it in its room.
void expectNothingOnAnything(const std::vector<LaneMark>& marks, const LaneLayout& layout,
                             const LaneRoom& room) {
    const auto x = [&](const LaneWord& word) { return word.x; };
    for (const LaneWord& word : layout.words) {
        EXPECT_GE(word.left, room.left);
        EXPECT_LE(word.right(), word.row + 1 == room.rows ? room.topEnd : room.wordsEnd);
        EXPECT_TRUE(word.left == x(word) + kLaneIndent || word.right() == x(word) - kLaneIndent);
        for (const LaneWord& other : layout.words) {
            if (&other == &word) continue;
            const bool apart = word.right() < other.left || other.right() < word.left;
            EXPECT_TRUE(apart || word.row != other.row) << x(word) << " on " << x(other);
            const bool crossed = x(word) > other.left && x(word) < other.right();
            EXPECT_FALSE(word.row > other.row && crossed) << "the line of " << x(word);
        }
    }
    for (const LaneWord& word : layout.words)
        EXPECT_LE(std::abs(word.x - marks[word.group.mark].x), 2);
    for (std::size_t i = 1; i < layout.glyphs.size(); ++i)
        EXPECT_GE(layout.glyphs[i].x - layout.glyphs[i - 1].x, kLaneGlyph);
    for (std::size_t i = 1; i < layout.lines.size(); ++i)
        EXPECT_GT(layout.lines[i].x - layout.lines[i - 1].x, 2);
}

TEST(MarkLane, AWordBeginsAtItsLineInTheTopRow) {
    const LaneLayout layout = layOutLane({{300, kWord, 0}}, kRoom, countWidth);
    ASSERT_EQ(layout.words.size(), 1U);
    EXPECT_EQ(layout.words[0].left, 300 + kLaneIndent);
    EXPECT_EQ(layout.words[0].row, 1);
    EXPECT_EQ(layout.glyphs, (std::vector<LanePlace>{{0, 300}}));
    EXPECT_EQ(layout.lines, (std::vector<LanePlace>{{0, 300}}));
}

TEST(MarkLane, WordsThatWouldCollideStandInRows) {
    const LaneLayout layout = layOutLane({{300, kWord, 0}, {320, kWord, 1}}, kRoom, countWidth);
    ASSERT_EQ(layout.words.size(), 2U);
    EXPECT_EQ(layout.words[0].row, 1);
    EXPECT_EQ(layout.words[1].row, 0);
}

TEST(MarkLane, AKindThatFindsNoRoomIsToldWithTheOneBefore) {
    const LaneLayout layout =
        layOutLane({{300, kWord, 0}, {320, kWord, 1}, {340, kWord, 1}, {345, kWord, 1}}, kRoom, countWidth);
    ASSERT_EQ(layout.words.size(), 2U);
    EXPECT_EQ(layout.words[1].group.count, 3);
    EXPECT_EQ(layout.words[1].width, 50);
    EXPECT_EQ(layout.lines.size(), 4U);
}

TEST(MarkLane, SixteenRobotsHeardAtTheSameInstantAreOneWord) {
    std::vector<LaneMark> marks{{300, kWord, 9}};
    for (unsigned robot = 0; robot < 16; ++robot)
        marks.push_back({300 + 0.125 * robot, kWord, 7, false, std::uint64_t{1} << robot});
    const LaneLayout layout = layOutLane(marks, kRoom, countWidth);
    ASSERT_EQ(layout.words.size(), 2U);
    EXPECT_EQ(layout.words[1].group.count, 16);
    EXPECT_EQ(layout.words[1].group.units, 0xFFFFU);
    EXPECT_EQ(layout.glyphs.size(), 1U);
}

TEST(MarkLane, WhatIsUrgentTakesTheRoomOfOthers) {
    const std::vector<LaneMark> marks{{300, kWord, 0}, {310, kWord, 1}, {320, kWord, 2, true}};
    const LaneLayout layout = layOutLane(marks, kRoom, countWidth);
    EXPECT_EQ(told(layout), (std::vector<std::size_t>{0, 2}));
    const LaneLayout both =
        layOutLane({{300, kWord, 0, true}, {310, kWord, 1, true}, {320, kWord, 2, true}}, kRoom, countWidth);
    EXPECT_EQ(told(both), (std::vector<std::size_t>{0, 1}));
}

TEST(MarkLane, AtTheRightEdgeAWordEndsAtItsLine) {
    const LaneLayout layout = layOutLane({{690, kWord, 0}}, kRoom, countWidth);
    ASSERT_EQ(layout.words.size(), 1U);
    EXPECT_EQ(layout.words[0].right(), 690 - kLaneIndent);
}

TEST(MarkLane, TheTopRowEndsWhereTheCursorsTimeBegins) {
    LaneRoom room = kRoom;
    room.topEnd = 500;
    const LaneLayout layout = layOutLane({{480, kWord, 0}, {560, kWord, 1}}, room, countWidth);
    ASSERT_EQ(layout.words.size(), 2U);
    EXPECT_EQ(layout.words[0].right(), 480 - kLaneIndent);
    EXPECT_EQ(layout.words[1].row, 0);
}

TEST(MarkLane, AMarkThatCameLaterMovesNoWord) {
    std::vector<LaneMark> marks;
    std::mt19937 random(7);
    LaneLayout before;
    for (int x = 110; x < 600; x += std::uniform_int_distribution(3, 50)(random)) {
        marks.push_back({static_cast<double>(x), kWord, static_cast<int>(random() % 3)});
        const LaneLayout after = layOutLane(marks, kRoom, countWidth);
        ASSERT_GE(after.words.size(), before.words.size());
        for (std::size_t i = 0; i < before.words.size(); ++i) {
            EXPECT_EQ(after.words[i].group.mark, before.words[i].group.mark);
            EXPECT_EQ(after.words[i].row, before.words[i].row);
            EXPECT_EQ(after.words[i].left, before.words[i].left);
        }
        before = after;
    }
    EXPECT_GT(before.words.size(), 5U);
}

TEST(MarkLane, WordsStayInTheirRowsWhileMarksLeaveAtTheLeft) {
    std::vector<LaneMark> marks;
    marks.reserve(30);
    for (int i = 0; i < 30; ++i)
        marks.push_back({110.0 + 19 * i, kWord, i % 3});
    const LaneLayout before = layOutLane(marks, kRoom, countWidth);
    for (LaneMark& mark : marks)
        mark.x -= 100;
    const LaneLayout after = layOutLane(marks, kRoom, countWidth);
    for (const LaneWord& word : before.words) {
        const auto same = std::find_if(after.words.begin(), after.words.end(), [&](const LaneWord& other) {
            return other.group.mark == word.group.mark;
        });
        if (marks[word.group.mark].x < kRoom.left) {
            EXPECT_EQ(same, after.words.end());
        } else if (marks[word.group.mark].x < 500) {
            ASSERT_NE(same, after.words.end());
            EXPECT_EQ(same->row, word.row);
        }
    }
}

TEST(MarkLane, HundredsOfMarksLeaveNothingOnAnything) {
    std::mt19937 random(1);
    for (const int count : {5, 40, 200, 700}) {
        for (int rows = 1; rows <= 3; ++rows) {
            std::vector<LaneMark> marks;
            for (int i = 0; i < count; ++i) {
                const int kind = static_cast<int>(random() % 9);
                marks.push_back({static_cast<double>(random() % 900), 30 + static_cast<int>(random() % 60),
                                 kind, kind > 6, std::uint64_t{1} << random() % 16});
            }
            std::sort(marks.begin(), marks.end(),
                      [](const LaneMark& a, const LaneMark& b) { return a.x < b.x; });
            const LaneRoom room{100, 700, 740, random() % 2 == 0 ? 740.0 : 580.0, rows};
            const LaneLayout layout = layOutLane(marks, room, countWidth);
            expectNothingOnAnything(marks, layout, room);
            EXPECT_FALSE(layout.words.empty());
        }
    }
}

TEST(NamePlaces, StandAboveTheirLinesAndElseBelow) {
    const QRectF area(0, 0, 400, 100);
    const auto places = placeNames({{40, 80}, {8, 60}}, 13, area, {});
    ASSERT_TRUE(places[0] && places[1]);
    EXPECT_EQ(places[0]->bottom(), 40);
    EXPECT_EQ(places[1]->top(), 9);
}

TEST(NamePlaces, MovePastTheTitleAndLeaveOutWhatFindsNoPlace) {
    const QRectF area(0, 0, 400, 40);
    const QRectF title(0, 1, 90, 13);
    const auto places = placeNames({{16, 80}, {30, 80}}, 13, area, {title});
    ASSERT_TRUE(places[0]);
    EXPECT_GT(places[0]->left(), title.right());
    std::vector<QRectF> taken{title};
    for (const auto& place : places) {
        if (!place) continue;
        for (const QRectF& other : taken)
            EXPECT_FALSE(place->intersects(other));
        EXPECT_TRUE(area.contains(*place));
        taken.push_back(*place);
    }
    EXPECT_FALSE(placeNames({{5, 80}}, 13, QRectF(0, 0, 400, 10), {})[0]);
}

TEST(NamePlaces, OfTwoThatCollideTheMoreImportantStaysAndTheOtherStandsNowhereElse) {
    const QRectF area(0, 0, 400, 100);
    const auto two = placeNames({{60, 80}, {55, 80}}, 13, area, {});
    ASSERT_TRUE(two[0] && two[1]);
    EXPECT_EQ(two[0]->top(), 61) << "above it would stand on the other line";
    EXPECT_EQ(two[1]->bottom(), 55);
    const auto three = placeNames({{60, 80}, {55, 80}, {50, 80}}, 13, area, {});
    EXPECT_TRUE(three[0] && three[2]);
    EXPECT_FALSE(three[1]) << "both its places belong to other lines";
    const auto low = placeNames({{95, 80}, {85, 80}}, 13, area, {});
    ASSERT_TRUE(low[1]);
    EXPECT_FALSE(low[0]);
}

}  // namespace
}  // namespace kickstand::ui
