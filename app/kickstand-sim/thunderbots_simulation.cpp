#include "app/kickstand-sim/thunderbots_simulation.h"

#include <QJsonArray>

#include "app/kickstand-sim/json.h"
#include "app/kickstand-sim/words.h"
#include "core/base/hex.h"
#include "core/thunderbots/wire/firmware.h"

namespace kickstand::sim {
namespace {

namespace wire = thunderbots::wire;
using thunderbots::sim::KickRecord;
using thunderbots::sim::RobotPower;
using thunderbots::sim::RobotReport;

constexpr int kVoltDigits = 2;
constexpr int kTimeDigits = 6;
constexpr int kSpeedDigits = 1;

QString nameOf(RobotPower power) {
    switch (power) {
        case RobotPower::Off:
            return QStringLiteral("off");
        case RobotPower::Booting:
            return QStringLiteral("booting");
        case RobotPower::CopyingImage:
            return QStringLiteral("copying-image");
        case RobotPower::Up:
            return QStringLiteral("up");
        case RobotPower::LockedOut:
            return QStringLiteral("locked-out");
    }
    return {};
}

QString nameOf(wire::FlashContents contents) {
    switch (contents) {
        case wire::FlashContents::FpgaBitstream:
            return QStringLiteral("fpga-bitstream");
        case wire::FlashContents::Microcontroller:
            return QStringLiteral("microcontroller");
        case wire::FlashContents::NoData:
            return QStringLiteral("no-data");
    }
    return {};
}

QJsonArray toJson(const wire::Channels& channels) {
    return {channels.channel0, channels.channel1};
}

template <class Numbers>
QJsonArray toArray(const Numbers& numbers) {
    QJsonArray json;
    for (const auto number : numbers)
        json.append(rounded(static_cast<double>(number), kSpeedDigits));
    return json;
}

QJsonObject toJson(const wire::OperationalParameters& parameters) {
    return {{QStringLiteral("flash_contents"), nameOf(parameters.flash())},
            {QStringLiteral("channels"), QJsonArray{parameters.channel0, parameters.channel1}},
            {QStringLiteral("robot_number"), parameters.robotNumber},
            {QStringLiteral("dribbler_duty"), parameters.dribblerDuty},
            {QStringLiteral("tail"), QString::fromStdString(toHex(parameters.tail.view()))}};
}

QJsonObject toJson(const wire::TestMode& mode) {
    return {{QStringLiteral("class"), QLatin1String(wire::name(mode.testClass))},
            {QStringLiteral("target"), mode.target}};
}

QJsonArray ledsToJson(std::uint8_t leds) {
    QJsonArray json;
    for (int led = 0; led < 4; ++led)
        json.append((leds >> led & 1) != 0);
    return json;
}

QJsonArray robotsToJson(std::uint16_t robots) {
    QJsonArray json;
    for (int robot = 0; robot < wire::kRobotCount; ++robot) {
        if ((robots >> robot & 1) != 0) json.append(robot);
    }
    return json;
}

qint64 toNumber(std::uint64_t count) {
    return static_cast<qint64>(count);
}

}  // namespace

ThunderbotsSimulation::ThunderbotsSimulation(Scheduler& scheduler,
                                             const thunderbots::sim::ThunderbotsSimOptions& options)
    : scheduler_(scheduler),
      start_(scheduler.now()),
      cable_(options.cableRobot.has_value()),
      sim_(scheduler, options) {}

std::vector<int> ThunderbotsSimulation::units() const {
    std::vector<int> all;
    for (int robot = 0; robot < wire::kRobotCount; ++robot) {
        if (sim_.hasRobot(robot)) all.push_back(robot);
    }
    return all;
}

QString ThunderbotsSimulation::description() const {
    QStringList numbers;
    for (const int robot : units())
        numbers << QString::number(robot);
    if (cable_) return Words::tr("Thunderbots robot %1 on a cable, simulated").arg(numbers.front());
    return Words::tr("a Thunderbots dongle and robots %1, simulated").arg(numbers.join(QStringLiteral(", ")));
}

std::vector<ValueWord> ThunderbotsSimulation::valueWords() const {
    if (cable_) return {};
    std::vector<ValueWord> words{{"radio-failure", "none", -1}};
    for (const auto state :
         {wire::EStop::Uninitialized, wire::EStop::Disconnected, wire::EStop::Stop, wire::EStop::Run})
        words.push_back({"e-stop", wire::name(state), static_cast<double>(state)});
    return words;
}

std::vector<ValueWord> ThunderbotsSimulation::shortcuts() const {
    return {{"dead", "kill", 1}, {"dead", "revive", 0}, {"plugged", "unplug", 0}, {"plugged", "replug", 1}};
}

double ThunderbotsSimulation::since(TimePoint time) const {
    return rounded(seconds(time - start_), kTimeDigits);
}

QJsonObject ThunderbotsSimulation::show() {
    const auto report = sim_.deviceReport();
    const auto value = [this](const char* action) {
        const auto found = sim_.control().value(action, -1);
        return found ? QJsonValue(*found) : QJsonValue();
    };
    const QJsonObject device{
        {QStringLiteral("kind"), cable_ ? QStringLiteral("cable") : QStringLiteral("dongle")},
        {QStringLiteral("attached"), report.attached},
        {QStringLiteral("configured"), report.configured},
        {QStringLiteral("emergency_stop"), QLatin1String(wire::name(report.status.eStop))},
        {QStringLiteral("radios"), QLatin1String(wire::name(report.status.radios))},
        {QStringLiteral("alive"), robotsToJson(report.status.aliveRobots)},
        {QStringLiteral("channels"), cable_ ? QJsonValue() : QJsonValue(toJson(report.channels))},
        {QStringLiteral("messages_held"), toNumber(report.messagesHeld)},
        {QStringLiteral("malformed"), toNumber(report.malformed)},
        {QStringLiteral("loss"), value("loss")},
        {QStringLiteral("duplicate"), value("duplicate")},
        {QStringLiteral("delay_ms"), value("delay")}};
    return {{QStringLiteral("time_s"), since(scheduler_.now())}, {QStringLiteral("device"), device}};
}

QJsonObject ThunderbotsSimulation::driveToJson(const RobotReport& robot) const {
    const wire::DriveBlock& block = robot.lastDrive;
    const wire::KickTimes& times = block.autokick;
    return {{QStringLiteral("fresh"), robot.driveFresh},
            {QStringLiteral("time_s"), since(robot.lastDriveTime)},
            {QStringLiteral("run"), block.run},
            {QStringLiteral("charge"), block.charge},
            {QStringLiteral("dribble"), block.dribble},
            {QStringLiteral("wheels"), toArray(block.wheels)},
            {QStringLiteral("test_class"), block.testClass},
            {QStringLiteral("test_target"), block.testTarget},
            {QStringLiteral("armed"), block.autokickArmed},
            {QStringLiteral("mask1"), times.flag1},
            {QStringLiteral("mask2"), times.flag2},
            {QStringLiteral("t1"), times.t1},
            {QStringLiteral("t2"), times.t2},
            {QStringLiteral("dt"), times.dt}};
}

QJsonObject ThunderbotsSimulation::kicksToJson(const RobotReport& robot) const {
    QJsonArray last;
    std::uint64_t number = robot.kicks - robot.lastKicks.size();
    for (const KickRecord& kick : robot.lastKicks) {
        const auto& [pulse1, pulse2] = kick.pulses;
        last.append(QJsonObject{{QStringLiteral("number"), toNumber(++number)},
                                {QStringLiteral("time_s"), since(kick.time)},
                                {QStringLiteral("automatic"), kick.automatic},
                                {QStringLiteral("start1_us"), pulse1.start_us},
                                {QStringLiteral("width1_us"), pulse1.width_us},
                                {QStringLiteral("start2_us"), pulse2.start_us},
                                {QStringLiteral("width2_us"), pulse2.width_us},
                                {QStringLiteral("before_V"), rounded(kick.before_V, kVoltDigits)},
                                {QStringLiteral("after_V"), rounded(kick.after_V, kVoltDigits)}});
    }
    return {{QStringLiteral("count"), toNumber(robot.kicks)},
            {QStringLiteral("automatic"), toNumber(robot.automaticKicks)},
            {QStringLiteral("last"), last}};
}

QJsonObject ThunderbotsSimulation::showUnit(int unit) const {
    const RobotReport robot = sim_.robot(unit);
    const bool driven = robot.driveBlocks > 0;
    return {
        {QStringLiteral("robot"), unit},
        {QStringLiteral("number"), robot.number},
        {QStringLiteral("power"), nameOf(robot.power)},
        {QStringLiteral("boots"), toNumber(robot.boots)},
        {QStringLiteral("channels"), toJson(robot.channels)},
        {QStringLiteral("fpga_configured"), robot.fpgaConfigured},
        {QStringLiteral("drive"), driven ? QJsonValue(driveToJson(robot)) : QJsonValue()},
        {QStringLiteral("drive_blocks"), toNumber(robot.driveBlocks)},
        {QStringLiteral("drive_changes"), toNumber(robot.driveChanges)},
        {QStringLiteral("drive_timeouts"), toNumber(robot.driveTimeouts)},
        {QStringLiteral("kicks"), kicksToJson(robot)},
        {QStringLiteral("test_mode"), toJson(robot.testMode)},
        {QStringLiteral("test_mode_messages"), toNumber(robot.testModeMessages)},
        {QStringLiteral("leds"), ledsToJson(robot.leds)},
        {QStringLiteral("wheel_speeds"), toArray(robot.wheelSpeeds)},
        {QStringLiteral("wheel_counts"), toArray(robot.wheelCounts)},
        {QStringLiteral("battery_V"), rounded(robot.battery_V, kVoltDigits)},
        {QStringLiteral("capacitor_V"), rounded(robot.capacitor_V, kVoltDigits)},
        {QStringLiteral("dribbler_C"), rounded(robot.dribbler_C, kVoltDigits)},
        {QStringLiteral("charging"), robot.charging},
        {QStringLiteral("dribbling"), robot.dribbling},
        {QStringLiteral("ball"), robot.ball},
        {QStringLiteral("parameters"), QJsonObject{{QStringLiteral("shadow"), toJson(robot.shadow)},
                                                   {QStringLiteral("committed"), toJson(robot.committed)}}},
        {QStringLiteral("malformed"), toNumber(robot.malformed)},
        {QStringLiteral("wrong_crcs"), toNumber(robot.wrongCrcs)},
        {QStringLiteral("lost_messages"), toNumber(robot.lostMessages)}};
}

std::uint32_t ThunderbotsSimulation::flashBytes() const {
    return wire::kFlashBytes;
}

void ThunderbotsSimulation::readFlash(int unit, std::uint32_t address, ByteSpan into) const {
    sim_.readFlash(unit, address, into);
}

}  // namespace kickstand::sim
