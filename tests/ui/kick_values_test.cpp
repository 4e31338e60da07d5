// What the kick panels keep and say: presets, labels, reasons, the table and its CSV.

#include <QSettings>
#include <QSignalSpy>
#include <QSortFilterProxyModel>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "core/thunderbots/wire/readings.h"
#include "ui/thunderbots/kick_presets.h"
#include "ui/thunderbots/kick_rows.h"
#include "ui/thunderbots/kick_settings.h"
#include "ui/thunderbots/kick_state.h"
#include "ui/thunderbots/kick_words.h"

namespace kickstand::ui {
namespace {

using namespace thunderbots;
using namespace std::chrono_literals;

class KickStored : public ::testing::Test {
  protected:
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
};

TEST_F(KickStored, PresetsAreSavedRenamedAndDeletedAndOutliveTheProgram) {
    KickPresets presets(settings);
    EXPECT_TRUE(presets.save(QStringLiteral("  soft   pass "), {1280, 0, 0}));
    EXPECT_TRUE(presets.save(QStringLiteral("chip"), {0, 2016, 0}));
    EXPECT_TRUE(presets.save(QStringLiteral("chip"), {320, 2016, 64})) << "the same name again replaces it";
    EXPECT_TRUE(presets.rename(QStringLiteral("soft pass"), QStringLiteral("pass")));
    EXPECT_FALSE(presets.rename(QStringLiteral("pass"), QStringLiteral("chip"))) << "that one is taken";
    EXPECT_FALSE(presets.rename(QStringLiteral("pass"), QStringLiteral("  ")));
    EXPECT_FALSE(presets.rename(QStringLiteral("nobody"), QStringLiteral("x")));
    EXPECT_FALSE(presets.save(QString(), {320, 0, 0}));
    const KickPresets again(settings);
    ASSERT_EQ(again.all().size(), 2U);
    EXPECT_EQ(again.find(QStringLiteral("chip"))->pulses, (wire::KickPulses{320, 2016, 64}));
    EXPECT_EQ(again.find(QStringLiteral("pass"))->pulses, (wire::KickPulses{1280, 0, 0}));
    presets.remove(QStringLiteral("chip"));
    EXPECT_EQ(KickPresets(settings).all().size(), 1U);
}

TEST_F(KickStored, ThereIsAnEndToPresets) {
    KickPresets presets(settings);
    for (std::size_t i = 0; i < KickPresets::kMost; ++i)
        ASSERT_TRUE(presets.save(QString::number(i), {320, 0, 0}));
    EXPECT_FALSE(presets.save(QStringLiteral("one more"), {320, 0, 0}));
    EXPECT_TRUE(presets.save(QStringLiteral("7"), {640, 0, 0})) << "one that is there may change";
}

TEST_F(KickStored, PulsesAndLabelsAreRememberedAndOddOnesAreTidied) {
    settings.setValue("kick/width1_us", 99999);
    settings.setValue("kick/offset_us", -33);
    KickSettings kick;
    kick.attach(settings);
    EXPECT_EQ(kick.pulses(), (wire::KickPulses{4064, 0, -32}));
    kick.setPulses({1000, 17, 5000});
    EXPECT_EQ(kick.pulses(), (wire::KickPulses{992, 32, 4064}));
    kick.setLabel(KickWay::First, QStringLiteral("  Boot "));
    KickSettings again;
    again.attach(settings);
    EXPECT_EQ(again.pulses(), kick.pulses());
    EXPECT_EQ(again.label(KickWay::First), QStringLiteral("Boot"));
    EXPECT_EQ(again.label(KickWay::Second), QStringLiteral("Chip"));
    again.setLabel(KickWay::First, QString());
    EXPECT_EQ(again.label(KickWay::First), QStringLiteral("Kick"));
}

TEST_F(KickStored, EachWayOfKickingUsesItsSolenoids) {
    const wire::KickPulses drawn{2400, 1280, 384};
    EXPECT_EQ(pulsesFor(KickWay::First, drawn), (wire::KickPulses{2400, 0, 0}));
    EXPECT_EQ(pulsesFor(KickWay::Second, drawn), (wire::KickPulses{0, 1280, 0}));
    EXPECT_EQ(pulsesFor(KickWay::Both, drawn), drawn);
}

class KickReasons : public ::testing::Test {
  protected:
    void SetUp() override {
        snapshot.link = LinkState::Running;
        snapshot.eStop = wire::EStop::Run;
        for (const std::size_t robot : {3U, 4U}) {
            snapshot.robots[robot].live = true;
            snapshot.intents[robot].highVoltageArmed = true;
        }
    }
    QString kick(RobotMask chosen, bool stopped = false) {
        return reasonNotToKick(&snapshot, summarize(snapshot, chosen), stopped, pulses, way);
    }
    bool says(const QString& reason, const char* words) { return reason.contains(QLatin1String(words)); }

    Snapshot snapshot;
    wire::KickPulses pulses{2400, 1280, 0};
    KickWay way = KickWay::First;
};

TEST_F(KickReasons, ThereIsNoneForARobotThatIsHeardAndArmed) {
    EXPECT_EQ(kick(maskOf(3)).toStdString(), "");
}

TEST_F(KickReasons, EachIsSaid) {
    EXPECT_TRUE(says(reasonNotToKick(nullptr, {}, false, pulses, way), "Not connected"));
    EXPECT_TRUE(says(kick(maskOf(3), true), "Re-arm"));
    EXPECT_TRUE(says(kick(0), "Choose a robot"));
    EXPECT_TRUE(says(kick(maskOf(9)), "not heard"));
    EXPECT_TRUE(says(kick(static_cast<RobotMask>(maskOf(3) | maskOf(4))), "choose one"));
    snapshot.intents[3].highVoltageArmed = false;
    EXPECT_TRUE(says(kick(maskOf(3)), "not armed"));
    snapshot.intents[3].highVoltageArmed = true;
    snapshot.eStop = wire::EStop::Stop;
    EXPECT_TRUE(says(kick(maskOf(3)), "emergency stop"));
    snapshot.eStop = wire::EStop::Run;
    snapshot.link = LinkState::Searching;
    EXPECT_TRUE(says(kick(maskOf(3)), "does not run"));
    snapshot.link = LinkState::Running;
    snapshot.sweep = SweepProgress{};
    snapshot.sweep->plan.robot = 3;
    EXPECT_TRUE(says(kick(maskOf(3)), "sweep"));
    EXPECT_EQ(kick(maskOf(4)).toStdString(), "");
}

TEST_F(KickReasons, AnEmptyOrImpossiblePulseIsSaid) {
    pulses = {0, 1280, 0};
    EXPECT_TRUE(says(kick(maskOf(3)), "Width 1"));
    way = KickWay::Second;
    EXPECT_EQ(kick(maskOf(3)).toStdString(), "");
    pulses = {2400, 4064, 384};
    EXPECT_TRUE(says(kick(maskOf(3)), "4064"));
    EXPECT_TRUE(says(reasonNotToAutokick(&snapshot, summarize(snapshot, maskOf(3)), false, {}), "disarmed"));
}

KickRecord measured(std::uint64_t number, double before_V = 219, double after_V = 148) {
    KickRecord record;
    record.number = number;
    record.robot = 3;
    record.time = TimePoint{std::chrono::seconds(number)};
    record.times = wire::KickTimes{true, false, 75, 52, 12};
    record.measure = KickMeasure::Recharged;
    record.before_V = before_V;
    record.after_V = after_V;
    record.recharge = 1900ms;
    return record;
}

KickRecord notMeasured(std::uint64_t number) {
    KickRecord record = measured(number);
    record.measure = KickMeasure::Lost;
    record.before_V.reset();
    record.after_V.reset();
    record.recharge.reset();
    return record;
}

std::chrono::system_clock::time_point wall(TimePoint time) {
    return std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(time.time_since_epoch()));
}

constexpr SessionId kSession = 7;
const QString kLink = QStringLiteral("sim:thunderbots");

TEST(KickWords, SayWhatWasMeasuredAndNeverDelivered) {
    EXPECT_EQ(measureText(measured(1)).toStdString(), "219 → 148 V (−71 V), charged again in 1.9 s");
    EXPECT_TRUE(measureText(notMeasured(1)).startsWith(QStringLiteral("not measured")));
    EXPECT_EQ(wireText({true, false, 75, 52, 12}).toStdString(), "t1 75 · t2 52 · Δt 12 · flags 1 0");
    SweepProgress sweep;
    sweep.stage = SweepStage::Ended;
    sweep.given = 3;
    EXPECT_EQ(sweepText(sweep).toStdString(), "Done: 3 kicks given to the dongle.");
    sweep.endedBy = Errc::NotCharging;
    sweep.total = 12;
    EXPECT_TRUE(sweepText(sweep).startsWith(QStringLiteral("Ended after 3 of 12 kicks.")))
        << qPrintable(sweepText(sweep));
}

TEST(KickWords, TellHowChargingGoes) {
    const TimePoint now{10s};
    EXPECT_EQ(chargeText({now - 2s, {}}, {}, true, now).toStdString(), "charging for 2.0 s");
    const Readings full{.capacitor_V = 217, .charged = true};
    EXPECT_EQ(chargeText({{}, 3100ms}, full, true, now).toStdString(),
              "charged · took 3.1 s from switching on");
}

TEST(KickWords, NeverCallWhatIsLiveNotCharged) {
    const auto at = [](double capacitor_V, bool charger) {
        return chargeText({}, Readings{.capacitor_V = capacitor_V}, charger, TimePoint{10s}).toStdString();
    };
    EXPECT_EQ(at(211, false), "charger off, still live");
    EXPECT_EQ(at(213, true), "recharging");
    EXPECT_EQ(at(wire::kCapacitorLive_V, false), "charger off, still live");
    EXPECT_EQ(at(wire::kCapacitorLive_V - 1, false), "not charged");
    KickRecord dropped = measured(1);
    dropped.measure = KickMeasure::NotRecharged;
    EXPECT_FALSE(measureText(dropped).contains(QStringLiteral("not charged"))) << "149 V are left";
    EXPECT_FALSE(measureWord(dropped.measure).contains(QStringLiteral("not charged")));
}

/// What a small window shows of it is one line.
TEST(KickWords, ASweepStoppedByHandIsToldInOneShortLine) {
    SweepProgress sweep;
    sweep.stage = SweepStage::Ended;
    sweep.endedBy = Errc::Cancelled;
    sweep.given = 3;
    sweep.total = 7;
    EXPECT_EQ(sweepText(sweep).toStdString(), "Stopped after 3 of 7 kicks.");
}

TEST(KickCsv, HasALineAKickAndEmptyCellsForWhatIsNotKnown) {
    std::vector<KickRow> rows{{measured(1), QStringLiteral("new \"ball\", wet"), 1, kLink},
                              {notMeasured(2), {}, 1, kLink}};
    rows[1].record.times.reset();
    const QStringList lines = kickCsv(rows, wall).split(u'\n');
    ASSERT_EQ(lines.size(), 4);
    EXPECT_EQ(lines[0].count(u','), 17);
    EXPECT_EQ(lines[1].toStdString(),
              "1970-01-01T00:00:01.000Z,3,asked,2400,1280,384,75,52,12,1,0,219.0,148.0,71.0,1.900,recharged,"
              "\"sim:thunderbots\",\"new \"\"ball\"\", wet\"");
    EXPECT_EQ(lines[2].toStdString(),
              "1970-01-01T00:00:02.000Z,3,asked,,,,,,,,,,,,,not-measured,\"sim:thunderbots\",\"\"");
}

TEST(KickRows, TakeNewKicksAndNewsOfThoseThatAreThere) {
    KickRows rows(wall);
    KickRecord open = measured(1);
    open.measure = KickMeasure::Waiting;
    open.after_V.reset();
    open.recharge.reset();
    rows.take(kSession, kLink, {open});
    QSignalSpy changed(&rows, &QAbstractItemModel::dataChanged);
    EXPECT_EQ(rows.data(rows.index(0, KickRows::Drop), Qt::DisplayRole).toString(), QStringLiteral("…"));
    rows.setData(rows.index(0, KickRows::Note), QStringLiteral("first"), Qt::EditRole);
    rows.take(kSession, kLink, {measured(1), notMeasured(2)});
    EXPECT_EQ(changed.size(), 2);
    ASSERT_EQ(rows.rowCount(), 2);
    EXPECT_EQ(rows.data(rows.index(0, KickRows::Drop), Qt::DisplayRole).toString(), QStringLiteral("71.0 V"));
    EXPECT_EQ(rows.data(rows.index(0, KickRows::Note), Qt::DisplayRole).toString(), QStringLiteral("first"));
    EXPECT_EQ(rows.data(rows.index(1, KickRows::Drop), Qt::DisplayRole).toString(), QStringLiteral("—"));
    rows.take(kSession, kLink, {notMeasured(2)});
    EXPECT_EQ(rows.rowCount(), 2) << "what the session has forgotten stays";
}

TEST(KickRows, StayWhenTheirSessionEndsAndThoseOfTheNextComeBehindThem) {
    KickRows rows(wall);
    KickRecord open = measured(1);
    open.measure = KickMeasure::Waiting;
    rows.take(kSession, kLink, {open});
    rows.setData(rows.index(0, KickRows::Note), QStringLiteral("first"), Qt::EditRole);
    EXPECT_FALSE(rows.hasSeveralLinks());
    rows.endAllBut({kSession});
    EXPECT_EQ(rows.rows()[0].record.measure, KickMeasure::Waiting);
    rows.endAllBut({});
    EXPECT_EQ(rows.rows()[0].record.measure, KickMeasure::Lost) << "nobody measures it any more";
    rows.take(kSession + 1, QStringLiteral("usb:"), {measured(1), measured(2)});
    rows.take(kSession, kLink, {measured(1)});
    ASSERT_EQ(rows.rowCount(), 3) << "numbers count within their session";
    EXPECT_TRUE(rows.hasSeveralLinks());
    EXPECT_EQ(rows.data(rows.index(0, KickRows::Note), Qt::DisplayRole).toString(), QStringLiteral("first"));
    EXPECT_EQ(rows.data(rows.index(1, KickRows::Link), Qt::DisplayRole).toString(), QStringLiteral("usb:"));
}

TEST(KickRows, AreBounded) {
    KickRows rows(wall);
    KickRecords records;
    for (std::uint64_t number = 1; number <= KickRows::kMost + 5; ++number) {
        records.push_back(measured(number));
        if (records.size() == 256 || number == KickRows::kMost + 5) {
            rows.take(kSession, kLink, records);
            records.clear();
        }
    }
    EXPECT_EQ(rows.rowCount(), static_cast<int>(KickRows::kMost));
    EXPECT_EQ(rows.rows().back().record.number, KickRows::kMost + 5);
}

TEST(KickRows, SortByTheirNumbers) {
    KickRows rows(wall);
    rows.take(kSession, kLink,
              {measured(1, 219, 100), measured(2, 219, 20), measured(3, 219, 200), notMeasured(4)});
    QSortFilterProxyModel sorted;
    sorted.setSourceModel(&rows);
    sorted.setSortRole(KickRows::kSortRole);
    sorted.sort(KickRows::Drop, Qt::AscendingOrder);
    std::vector<int> order;
    for (int row = 0; row < 4; ++row)
        order.push_back(sorted.mapToSource(sorted.index(row, 0)).row());
    EXPECT_EQ(order, (std::vector<int>{2, 0, 1, 3})) << "as numbers, and what is not known behind them";
}

TEST(KickRows, OnlyNotesCanBeWritten) {
    KickRows rows(wall);
    rows.take(kSession, kLink, {measured(1)});
    EXPECT_TRUE(rows.flags(rows.index(0, KickRows::Note)).testFlag(Qt::ItemIsEditable));
    EXPECT_FALSE(rows.flags(rows.index(0, KickRows::Drop)).testFlag(Qt::ItemIsEditable));
    EXPECT_FALSE(rows.setData(rows.index(0, KickRows::Drop), 5, Qt::EditRole));
    EXPECT_TRUE(rows.setData(rows.index(0, KickRows::Note), QString(500, u'x'), Qt::EditRole));
    EXPECT_EQ(rows.rows()[0].note.size(), KickRows::kLongestNote);
}

}  // namespace
}  // namespace kickstand::ui
