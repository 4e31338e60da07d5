#include "ui/thunderbots/tile_marks.h"

#include <QCoreApplication>
#include <array>

namespace kickstand::ui {

namespace {

using namespace thunderbots;

struct MarkText {
    Q_DECLARE_TR_FUNCTIONS(TileMarks)
};

/// What a tile shows of a battery is rounded to this.
constexpr double kSeenStep_V = 0.1;
/// Of two, neither is odd.
constexpr int kLeastFleet = 3;

const RobotState& stateOf(const Snapshot& snapshot, int robot) {
    return snapshot.robots[static_cast<std::size_t>(robot)];
}

int lowestBattery(const Snapshot& snapshot, int before) {
    int lowest = -1;
    int current = 0;
    const auto volts = [&snapshot](int robot) { return stateOf(snapshot, robot).readings.battery_V; };
    for (int robot = 0; robot < kRobots; ++robot) {
        if (stateOf(snapshot, robot).freshness != Freshness::Current) continue;
        ++current;
        if (lowest < 0 || volts(robot) < volts(lowest)) lowest = robot;
    }
    if (current < 2) return -1;
    const bool hadOne = before >= 0 && stateOf(snapshot, before).freshness == Freshness::Current;
    return hadOne && volts(before) - volts(lowest) < kSeenStep_V ? before : lowest;
}

/// The one robot of those told something for which a thing is as for no other; −1 where it is not one.
template <class Has>
int oneAlone(const Snapshot& snapshot, Has has) {
    std::array<int, 2> count{};
    std::array<int, 2> last{-1, -1};
    for (int robot = 0; robot < kRobots; ++robot) {
        const RobotState& state = stateOf(snapshot, robot);
        if (!state.live || !state.told) continue;
        const std::size_t side = has(*state.told) ? 1 : 0;
        ++count.at(side);
        last.at(side) = robot;
    }
    if (count[0] + count[1] < kLeastFleet) return -1;
    if (count[1] == 1) return last[1];
    return count[0] == 1 ? last[0] : -1;
}

}  // namespace

TileMarks tileMarks(const Snapshot& snapshot, int lowestBefore) {
    TileMarks marks;
    marks.cable = snapshot.cable;
    marks.lowestBattery = lowestBattery(snapshot, lowestBefore);
    using Block = wire::DriveBlock;
    const auto mark = [&](auto has, const QString& with, const QString& without) {
        if (marks.oddOne >= 0) return;
        marks.oddOne = oneAlone(snapshot, has);
        if (marks.oddOne < 0) return;
        marks.oddBy = has(*stateOf(snapshot, marks.oddOne).told) ? with : without;
    };
    mark([](const Block& told) { return told.autokickArmed; }, MarkText::tr("armed for autokick"),
         MarkText::tr("not armed for autokick"));
    mark([](const Block& told) { return told.charge; }, MarkText::tr("charging"),
         MarkText::tr("not charging"));
    mark([](const Block& told) { return told.run; }, MarkText::tr("running"), MarkText::tr("braked"));
    mark([](const Block& told) { return told.dribble; }, MarkText::tr("dribbling"),
         MarkText::tr("not dribbling"));
    return marks;
}

}  // namespace kickstand::ui
