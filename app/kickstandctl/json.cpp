#include "app/kickstandctl/json.h"

#include <QDateTime>
#include <QTimeZone>
#include <array>
#include <cmath>

#include "core/engine/describe_facts.h"

namespace kickstand::ctl {
namespace {

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString nameOf(const EngineNote& note) {
    static constexpr std::array kNames{"stopped", "rearmed", "answers-lost", "session-opened",
                                       "session-closed"};
    return QLatin1String(kNames.at(static_cast<std::size_t>(note.kind)));
}
QString nameOf(const SystemEvent& event) {
    return fromView(std::visit([](const auto& one) { return name(one.kind); }, event));
}

}  // namespace

double rounded(double value) {
    return std::round(value * 100) / 100;
}

QString name(thunderbots::Freshness freshness) {
    switch (freshness) {
        case thunderbots::Freshness::NotHeard:
            return QStringLiteral("not-heard");
        case thunderbots::Freshness::Waiting:
            return QStringLiteral("waiting");
        case thunderbots::Freshness::Current:
            return QStringLiteral("current");
        case thunderbots::Freshness::Stale:
            return QStringLiteral("stale");
    }
    return {};
}

QString isoTime(const Engine& engine, TimePoint time) {
    const auto sinceEpoch = engine.wallTime(time).time_since_epoch();
    const auto sinceEpoch_ms = std::chrono::duration_cast<std::chrono::milliseconds>(sinceEpoch).count();
    return QDateTime::fromMSecsSinceEpoch(sinceEpoch_ms, Qt::UTC).toString(Qt::ISODateWithMs);
}

QJsonObject toJson(const Failure& failure) {
    QJsonObject json{{QStringLiteral("code"), failure.code},
                     {QStringLiteral("what"), failure.text.what},
                     {QStringLiteral("remedy"), failure.text.remedy}};
    if (!failure.text.remedyCommand.isEmpty()) json[QStringLiteral("command")] = failure.text.remedyCommand;
    return json;
}

QJsonObject toJson(const Error& error) {
    return toJson(failed(error).value());
}

QJsonObject toJson(const FoundDevice& device) {
    QJsonObject json{{QStringLiteral("link"), QString::fromStdString(toString(device.uri))},
                     {QStringLiteral("port"), QString::fromStdString(device.info.port)},
                     {QStringLiteral("manufacturer"), QString::fromStdString(device.info.manufacturer)},
                     {QStringLiteral("product"), QString::fromStdString(device.info.productName)},
                     {QStringLiteral("vendor_id"), device.info.vendor},
                     {QStringLiteral("product_id"), device.info.product},
                     {QStringLiteral("obstacle"), QJsonValue::Null}};
    if (device.obstacle) json[QStringLiteral("obstacle")] = toJson(*device.obstacle);
    return json;
}

QJsonObject robotToJson(int number, const thunderbots::RobotState& robot, TimePoint now) {
    QJsonObject json{{QStringLiteral("robot"), number},
                     {QStringLiteral("live"), robot.live},
                     {QStringLiteral("freshness"), name(robot.freshness)},
                     {QStringLiteral("readings"), QJsonValue::Null}};
    if (robot.feedback) {
        const auto& readings = robot.readings;
        const auto& raw = *robot.feedback;
        json[QStringLiteral("readings")] =
            QJsonObject{{QStringLiteral("battery_V"), rounded(readings.battery_V)},
                        {QStringLiteral("battery_adc"), raw.battery_adc},
                        {QStringLiteral("capacitor_V"), rounded(readings.capacitor_V)},
                        {QStringLiteral("capacitor_adc"), raw.capacitor_adc},
                        {QStringLiteral("dribbler_C"), rounded(readings.dribbler_C)},
                        {QStringLiteral("dribbler_adc"), raw.thermistor_adc},
                        {QStringLiteral("light_adc"), readings.light_adc},
                        {QStringLiteral("ball"), readings.ball},
                        {QStringLiteral("charged"), readings.charged}};
    }
    if (robot.freshness == thunderbots::Freshness::Stale)
        json[QStringLiteral("age_s")] = rounded(seconds(now - robot.currentUntil));
    return json;
}

QJsonObject linkToJson(const LinkUri& uri, const thunderbots::Snapshot& state) {
    QJsonObject json{{QStringLiteral("link"), QString::fromStdString(toString(uri))},
                     {QStringLiteral("simulated"), uri.isSimulated()},
                     {QStringLiteral("cable"), state.cable},
                     {QStringLiteral("state"), fromView(thunderbots::name(state.link))},
                     {QStringLiteral("emergency_stop"), QLatin1String(thunderbots::wire::name(state.eStop))},
                     {QStringLiteral("radios"), QLatin1String(thunderbots::wire::name(state.radios))},
                     {QStringLiteral("channels"), QJsonValue::Null}};
    if (state.channels)
        json[QStringLiteral("channels")] = QJsonArray{state.channels->channel0, state.channels->channel1};
    if (state.roundTrip)
        json[QStringLiteral("server_round_trip_ms")] = rounded(seconds(*state.roundTrip) * 1000);
    return json;
}

QJsonObject toJson(const Engine& engine, const EngineEvent& event) {
    QJsonObject json{
        {QStringLiteral("type"), QStringLiteral("event")},
        {QStringLiteral("time"), isoTime(engine, timeOf(event))},
        {QStringLiteral("event"), std::visit([](const auto& body) { return nameOf(body); }, event.body)},
        {QStringLiteral("text"), describe(event).text}};
    if (const int robot = robotOf(event); robot >= 0) json[QStringLiteral("robot")] = robot;
    const auto* system = std::get_if<SystemEvent>(&event.body);
    const auto* board = system == nullptr ? nullptr : std::get_if<smartdevice::Event>(system);
    if (board != nullptr && board->robot >= 0) json[QStringLiteral("device")] = printable(board->device);
    const auto* own = system == nullptr ? nullptr : std::get_if<coach::Event>(system);
    if (own != nullptr && own->team >= 0) json[QStringLiteral("team")] = own->team;
    return json;
}

QJsonArray toJson(thunderbots::RobotMask robots) {
    QJsonArray numbers;
    for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
        if (thunderbots::contains(robots, robot)) numbers.append(robot);
    }
    return numbers;
}

}  // namespace kickstand::ctl
