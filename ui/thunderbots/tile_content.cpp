#include "ui/thunderbots/tile_content.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "core/thunderbots/wire/readings.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {

namespace {

using namespace thunderbots;

/// A full battery of these robots: four cells of 4.2 V.
constexpr double kBatteryFull_V = 16.8;
constexpr double kCapacitorFull_V = 230;

struct TileText {
    Q_DECLARE_TR_FUNCTIONS(RobotTile)
};

double batteryPart(double volts) {
    return std::clamp((volts - wire::kBatteryLockOut_V) / (kBatteryFull_V - wire::kBatteryLockOut_V), 0.0,
                      1.0);
}

double capacitorPart(double volts) {
    return std::clamp(volts / kCapacitorFull_V, 0.0, 1.0);
}

/// Bars move in steps that can be seen, so that noise repaints nothing.
double step(double part) {
    return std::round(part * 64) / 64;
}

void addTold(TileContent& tile, const wire::DriveBlock& told) {
    const bool turns =
        std::any_of(told.wheels.begin(), told.wheels.end(), [](int speed) { return speed != 0; });
    tile.moving = told.run && turns;
    tile.motion = !told.run ? TileText::tr("braked")
                  : turns   ? TileText::tr("moving")
                            : TileText::tr("holding");
}

/// What is dangerous comes first.
void addChips(TileContent& tile, const Readings& readings, const wire::DriveBlock& told) {
    using Weight = TileContent::Weight;
    if (readings.charged) {
        tile.chips.push_back(
            {told.charge ? TileText::tr("kept full") : TileText::tr("charged"), Weight::Danger});
    } else if (told.charge) {
        tile.chips.push_back({TileText::tr("charging"), Weight::Warning});
    }
    if (told.autokickArmed) tile.chips.push_back({TileText::tr("autokick"), Weight::Warning});
    if (readings.ball) tile.chips.push_back({TileText::tr("ball"), Weight::Accent, TileContent::Sign::Ball});
    if (told.dribble)
        tile.chips.push_back({TileText::tr("dribbler"), Weight::Plain, TileContent::Sign::Dribbler});
}

void addBattery(TileContent& tile, const Readings& readings) {
    tile.battery = batteryText(readings.battery_V);
    tile.batteryLevel = step(batteryPart(readings.battery_V));
    if (tile.stale) return;
    if (readings.battery_V < wire::kBatteryEmpty_V) {
        tile.batteryWord = TileText::tr("empty");
        tile.batteryWeight = TileContent::Weight::Warning;
    } else if (readings.battery_V < wire::kBatteryLow_V) {
        tile.batteryWord = TileText::tr("low");
        tile.batteryWeight = TileContent::Weight::Warning;
    } else if (tile.lowestBattery) {
        tile.batteryWord = TileText::tr("lowest");
    }
}

void addCapacitor(TileContent& tile, const RobotState& state) {
    const double volts = state.capacitor ? state.capacitor->last_V : state.readings.capacitor_V;
    tile.capacitor = capacitorText(volts);
    if (tile.stale) tile.capacitor += u'?';
    tile.capacitorLevel = step(capacitorPart(volts));
    tile.capacitorLive = isLive(state);
}

void addStale(TileContent& tile, const RobotState& state, TimePoint now) {
    const QString age = ageText(now - state.currentUntil);
    // Heard, and yet without readings that are valid.
    if (state.live) tile.state = TileText::tr("heard, readings %1 old").arg(age);
    if (tile.capacitorLive) {
        tile.chips.push_back(
            {TileText::tr("last seen %1 ago: treat as live").arg(age), TileContent::Weight::Danger});
    } else if (!state.live) {
        tile.state = TileText::tr("last seen %1 ago").arg(age);
    }
}

/// Unchanged readings are not sent again: those of a robot that is heard are of now, however long ago they
/// came.
void addCurrent(TileContent& tile, const RobotState& state, bool cable) {
    tile.state = cable ? TileText::tr("cable ok \u00b7 now") : TileText::tr("radio ok \u00b7 now");
    tile.stateShort = TileText::tr("now");
    addChips(tile, state.readings, state.told.value_or(wire::brakedBlock()));
    if (state.told) addTold(tile, *state.told);
}

QString sentence(const TileContent& tile) {
    QStringList parts{TileText::tr("Robot %1").arg(tile.robot)};
    if (tile.known) {
        QString battery = TileText::tr("battery %1").arg(tile.battery);
        if (tile.batteryWeight == TileContent::Weight::Warning) battery += u' ' + tile.batteryWord;
        parts << battery;
        if (tile.lowestBattery) parts << TileText::tr("the lowest of all");
        parts << (tile.capacitorLive ? TileText::tr("capacitor %1, live") : TileText::tr("capacitor %1"))
                     .arg(tile.capacitor);
    }
    for (const TileContent::Chip& chip : tile.chips)
        parts << chip.text;
    if (!tile.motion.isEmpty()) parts << tile.motion;
    if (!tile.state.isEmpty()) parts << tile.state;
    if (!tile.oddBy.isEmpty()) parts << TileText::tr("the only one %1").arg(tile.oddBy);
    if (tile.chosen) parts << TileText::tr("chosen");
    return parts.join(QStringLiteral(", "));
}

QString hearingTip(const RobotState& state, TimePoint now, bool cable) {
    if (state.freshness == Freshness::Stale) {
        const QString old = state.live ? TileText::tr("Heard, but its readings have not been valid for %1.")
                                       : TileText::tr("Lost %1 ago: the readings are of before.");
        return old.arg(ageText(now - state.currentUntil));
    }
    const QString heard = cable ? TileText::tr("Heard over the cable now.")
                                : TileText::tr("Heard by the dongle\u2019s radio now.");
    if (!state.capacitor) return heard;
    // A block is sent when it differs from the one before.
    return heard + u' ' +
           TileText::tr("The readings last changed %1 ago.").arg(ageText(now - state.capacitor->at));
}

}  // namespace

const double kBatteryEmptyMark = batteryPart(wire::kBatteryEmpty_V);
const double kBatteryLowMark = batteryPart(wire::kBatteryLow_V);
const double kCapacitorLiveMark = capacitorPart(wire::kCapacitorLive_V);
const double kCapacitorChargedMark = capacitorPart(wire::kCapacitorCharged_V);

TileContent tileContent(int robot, const RobotState& state, bool chosen, TimePoint now,
                        const TileMarks& marks) {
    TileContent tile;
    tile.robot = robot;
    tile.live = state.live;
    tile.chosen = chosen;
    tile.known = state.feedback.has_value();
    tile.stale = state.freshness == Freshness::Stale;
    tile.lowestBattery = marks.lowestBattery == robot && state.freshness == Freshness::Current;
    if (marks.oddOne == robot) tile.oddBy = marks.oddBy;
    if (tile.known) {
        addBattery(tile, state.readings);
        addCapacitor(tile, state);
    }
    switch (state.freshness) {
        case Freshness::NotHeard:
            tile.state = TileText::tr("not heard");
            break;
        case Freshness::Waiting:
            tile.state = TileText::tr("heard, no readings yet");
            break;
        case Freshness::Current:
            addCurrent(tile, state, marks.cable);
            break;
        case Freshness::Stale:
            addStale(tile, state, now);
            break;
    }
    tile.accessible = sentence(tile);
    return tile;
}

QString readingsTip(int robot, const RobotState& state, TimePoint now, const TileMarks& marks) {
    if (state.freshness == Freshness::Waiting)
        return TileText::tr("Robot %1 is heard, and has sent no readings yet.").arg(robot);
    if (!state.feedback) return TileText::tr("Robot %1 has not been heard.").arg(robot);
    const wire::FeedbackBlock& raw = *state.feedback;
    const Readings& readings = state.readings;
    QStringList lines{TileText::tr("Robot %1").arg(robot)};
    lines << hearingTip(state, now, marks.cable);
    lines << TileText::tr("Battery %1 V (ADC %2): low below %3 V, empty below %4 V")
                 .arg(readings.battery_V, 0, 'f', 2)
                 .arg(raw.battery_adc)
                 .arg(wire::kBatteryLow_V, 0, 'f', 1)
                 .arg(wire::kBatteryEmpty_V, 0, 'f', 1);
    lines << TileText::tr("Capacitor %1 V (ADC %2): live from %3 V")
                 .arg(readings.capacitor_V, 0, 'f', 1)
                 .arg(raw.capacitor_adc)
                 .arg(wire::kCapacitorLive_V, 0, 'f', 0);
    lines << TileText::tr("Dribbler %1 \u00b0C (ADC %2)")
                 .arg(readings.dribbler_C, 0, 'f', 0)
                 .arg(raw.thermistor_adc);
    lines << TileText::tr("Break beam (ADC %1): %2")
                 .arg(raw.light_adc)
                 .arg(readings.ball ? TileText::tr("ball") : TileText::tr("no ball"));
    if (marks.oddOne == robot) lines << TileText::tr("The only one %1.").arg(marks.oddBy);
    return lines.join(u'\n');
}

}  // namespace kickstand::ui
