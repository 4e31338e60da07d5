#include "app/kickstandctl/kick_options.h"

#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

namespace wire = thunderbots::wire;

/// Beyond anything that has an encoding, so that the error can name the edge that does not fit.
constexpr int kLongest_us = 1000000;

/// Reads one of the three; 0 where it was not given.
Outcome read(const Invocation& invocation, const char* option, int lowest, int& value_us) {
    if (!invocation.has(option)) return {};
    const auto parsed = parseWhole(invocation.text(option), option, lowest, kLongest_us);
    if (!parsed) return tl::unexpected(parsed.error());
    value_us = *parsed;
    return {};
}

}  // namespace

Expected<wire::KickEncoding> readKick(const Invocation& invocation) {
    wire::KickPulses asked;
    if (auto width1 = read(invocation, "--width1", 0, asked.width1_us); !width1)
        return tl::unexpected(width1.error());
    if (auto width2 = read(invocation, "--width2", 0, asked.width2_us); !width2)
        return tl::unexpected(width2.error());
    if (auto offset = read(invocation, "--offset", -kLongest_us, asked.offset_us); !offset)
        return tl::unexpected(offset.error());
    const auto encoded = wire::encodePulses(asked);
    if (!encoded) return refusedInput(wire::toError(encoded.error()));
    if (encoded->sent.width1_us == 0 && encoded->sent.width2_us == 0)
        return refusedInput({.code = Errc::NoEncoding});
    return *encoded;
}

QJsonObject kickToJson(const wire::KickEncoding& kick) {
    return {{QStringLiteral("width1_us"), kick.sent.width1_us},
            {QStringLiteral("width2_us"), kick.sent.width2_us},
            {QStringLiteral("offset_us"), kick.sent.offset_us},
            {QStringLiteral("snapped"), kick.snapped},
            {QStringLiteral("t1"), kick.times.t1},
            {QStringLiteral("t2"), kick.times.t2},
            {QStringLiteral("dt"), kick.times.dt},
            {QStringLiteral("mask1"), kick.times.flag1},
            {QStringLiteral("mask2"), kick.times.flag2}};
}

QString kickText(const wire::KickEncoding& kick) {
    const wire::KickPulses& sent = kick.sent;
    QString text = Words::tr("%1 / %2 µs").arg(sent.width1_us).arg(sent.width2_us);
    if (sent.offset_us > 0) text += Words::tr(", solenoid 2 later by %1 µs").arg(sent.offset_us);
    if (sent.offset_us < 0) text += Words::tr(", solenoid 1 later by %1 µs").arg(-sent.offset_us);
    if (kick.snapped) text += Words::tr(" (on the grid of 32 µs)");
    return text;
}

}  // namespace kickstand::ctl
