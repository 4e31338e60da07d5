// Nothing on a tile covers anything else, whatever the robot is up to.

#include "ui/thunderbots/tile_layout.h"

#include <QApplication>
#include <QFontDatabase>

#include <gtest/gtest.h>

#include "ui/thunderbots/robot_tile.h"

namespace kickstand::ui {
namespace {

using namespace thunderbots;

constexpr TimePoint kNow{std::chrono::hours(10)};

RobotState robot(double battery_V, double capacitor_V) {
    RobotState state;
    state.live = true;
    state.freshness = Freshness::Current;
    state.feedback = wire::FeedbackBlock{};
    state.readings.battery_V = battery_V;
    state.readings.capacitor_V = capacitor_V;
    state.capacitor = CapacitorMemory{capacitor_V, kNow};
    state.told = wire::brakedBlock();
    return state;
}

void expectApart(const TileContent& tile, const QSizeF& size) {
    const auto parts = layOutTile(tile, size).parts();
    const QRectF frame = QRectF(QPointF(), size).adjusted(3, 1, -3, -1);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_TRUE(frame.contains(parts[i].second))
            << parts[i].first.toStdString() << " leaves the tile: " << tile.accessible.toStdString();
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_FALSE(parts[i].second.intersects(parts[j].second))
                << parts[i].first.toStdString() << " covers " << parts[j].first.toStdString() << ": "
                << tile.accessible.toStdString();
        }
    }
}

/// Every combination of what a robot that is heard can be up to.
template <class Each>
void forEveryState(Each each) {
    for (const double battery_V : {13.9, 14.9, 15.9}) {
        for (const double capacitor_V : {0.0, 219.4}) {
            for (unsigned bits = 0; bits < 1U << 7; ++bits) {
                RobotState state = robot(battery_V, capacitor_V);
                state.readings.charged = capacitor_V > 215 && (bits & 1) != 0;
                state.readings.ball = (bits & 2) != 0;
                state.told->charge = (bits & 4) != 0;
                state.told->autokickArmed = (bits & 8) != 0;
                state.told->dribble = (bits & 16) != 0;
                state.told->run = (bits & 32) != 0;
                state.told->wheels[0] = (bits & 64) != 0 ? 5 : 0;
                each(state);
            }
        }
    }
}

class TileLayoutTest : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        const QString family = QString::fromLatin1(GetParam());
        if (!QFontDatabase::families().contains(family)) GTEST_SKIP() << "this font is not installed";
        QFont font(family);
        font.setPixelSize(13);
        QApplication::setFont(font);
    }
    void TearDown() override { QApplication::setFont(before_); }

    static QSizeF least() { return {kLeastTileWidth, RobotTile::kLeastHeight}; }

  private:
    QFont before_ = QApplication::font();
};

TEST_P(TileLayoutTest, NothingOverlapsWhateverARobotIsUpTo) {
    const TileMarks marks{15, 15, QStringLiteral("charging")};
    forEveryState([&](const RobotState& state) {
        for (const int number : {3, 15}) {
            const TileContent tile = tileContent(number, state, true, kNow, marks);
            expectApart(tile, least());
            expectApart(tile, QSizeF(kLeastTileWidth, RobotTile::kMostHeight));
        }
    });
}

TEST_P(TileLayoutTest, NothingOverlapsOnALostRobotHoweverLongAgo) {
    for (const Duration ago : {Duration(std::chrono::seconds(0)), Duration(std::chrono::seconds(119)),
                               Duration(std::chrono::minutes(119)), Duration(std::chrono::hours(9))}) {
        for (const double capacitor_V : {0.0, 219.4}) {
            RobotState state = robot(13.2, capacitor_V);
            state.live = false;
            state.freshness = Freshness::Stale;
            state.currentUntil = kNow - ago;
            const TileContent tile = tileContent(15, state, true, kNow);
            expectApart(tile, least());
            expectApart(tile, QSizeF(kLeastTileWidth, RobotTile::kMostHeight));
        }
    }
}

TEST_P(TileLayoutTest, ChargingAndAutokickAlwaysKeepTheirWords) {
    forEveryState([](const RobotState& state) {
        const TileContent tile = tileContent(15, state, false, kNow);
        const TileLayout layout = layOutTile(tile, least());
        ASSERT_EQ(layout.chips.size(), tile.chips.size());
        for (std::size_t i = 0; i < tile.chips.size(); ++i) {
            const bool word = layout.chips[i].lines == QStringList{tile.chips[i].text};
            EXPECT_TRUE(word || tile.chips[i].sign != TileContent::Sign::None)
                << tile.chips[i].text.toStdString();
        }
    });
}

TEST_P(TileLayoutTest, HowARobotIsHeardAlwaysShows) {
    forEveryState([](const RobotState& state) {
        const TileContent tile = tileContent(15, state, false, kNow);
        const TileLayout layout = layOutTile(tile, least());
        EXPECT_FALSE(layout.radio.isNull()) << tile.accessible.toStdString();
        EXPECT_TRUE(layout.stateText.isEmpty() || layout.stateText == tile.state ||
                    layout.stateText == tile.stateShort)
            << layout.stateText.toStdString();
        const bool quiet = tile.chips.empty();
        EXPECT_TRUE(!quiet || layout.stateText == tile.state) << layout.stateText.toStdString();
    });
    TileMarks cable;
    cable.cable = true;
    const TileContent wired = tileContent(15, robot(15.9, 0), false, kNow, cable);
    EXPECT_EQ(layOutTile(wired, least()).stateText, wired.state);
    EXPECT_TRUE(layOutTile(tileContent(15, RobotState{}, false, kNow), least()).radio.isNull());
}

TEST_P(TileLayoutTest, ALostLiveCapacitorIsSaidInFull) {
    RobotState state = robot(13.2, 219.4);
    state.live = false;
    state.freshness = Freshness::Stale;
    state.currentUntil = kNow - std::chrono::minutes(119);
    const TileContent tile = tileContent(15, state, false, kNow);
    const TileLayout layout = layOutTile(tile, least());
    ASSERT_EQ(layout.chips.size(), 1U);
    EXPECT_EQ(layout.chips[0].lines.join(u' '), QStringLiteral("last seen 119 min ago: treat as live"));
}

INSTANTIATE_TEST_SUITE_P(Fonts, TileLayoutTest, testing::Values("Noto Sans", "DejaVu Sans"),
                         [](const auto& font) { return QString(font.param).remove(u' ').toStdString(); });

}  // namespace
}  // namespace kickstand::ui
