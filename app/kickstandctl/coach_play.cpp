#include "app/kickstandctl/coach_play.h"

#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_coach.h"

namespace kickstand::ctl {
namespace {

constexpr Duration kSentLimit = std::chrono::seconds(3);

}  // namespace

Expected<coach::wire::TeamColor> readColor(const Invocation& invocation) {
    const std::string_view text = invocation.text("--color");
    if (text.empty() || text == "red") return coach::wire::TeamColor::Red;
    if (text == "blue") return coach::wire::TeamColor::Blue;
    return badUsage(
        Words::tr("“%1” is no team color.").arg(QString::fromUtf8(text.data(), qsizetype(text.size()))),
        Words::tr("Give red or blue."));
}

Outcome CoachPlay::connect() {
    runner_.setObserver([this](const EngineEvent& event) {
        context_.output.value(toJson(runner_.engine(), event));
        context_.output.line(eventLine(runner_.engine(), event));
    });
    return connectRadio(context_, runner_);
}

Outcome CoachPlay::pair() {
    const auto color = readColor(context_.invocation);
    if (!color) return tl::unexpected(color.error());
    int boat = -1;
    if (context_.invocation.has("--boat")) {
        const auto given = parseWhole(context_.invocation.text("--boat"), "--boat", 0, 255);
        if (!given) return tl::unexpected(given.error());
        boat = *given;
    }
    if (auto connected = connect(); !connected) return connected;
    return pairWith(runner_, boat, *color);
}

void CoachPlay::tell(const QString& type, QJsonObject facts, const QString& text) {
    facts[QStringLiteral("type")] = type;
    context_.output.value(facts);
    context_.output.line(text);
}

Outcome CoachPlay::keepFor(Duration span) {
    const auto left =
        runner_.waitUntil([this] { return radioOf(runner_).coach.state != coach::CoachState::Paired; }, span);
    if (!left) return tl::unexpected(left.error());
    if (*left) return failed({.code = Errc::NotPaired});
    return {};
}

Outcome CoachPlay::awaitSent(coach::wire::Opcode opcode) {
    std::optional<coach::TrafficEntry> sent;
    const auto known = runner_.waitUntil(
        [&] {
            for (const coach::TrafficEntry& entry : *radioOf(runner_).entries) {
                if (entry.sent && entry.message.opcode == opcode && entry.outcome) sent = entry;
            }
            return sent.has_value();
        },
        kSentLimit);
    if (!known) return tl::unexpected(known.error());
    if (!*known) return failed({.code = Errc::TimedOut, .subject = coach::wire::specOf(opcode).name});
    const bool acknowledged = *sent->outcome == 0;
    tell(QStringLiteral("sent"),
         {{QStringLiteral("message"), QString::fromUtf8(coach::wire::specOf(opcode).name)},
          {QStringLiteral("acknowledged"), acknowledged}},
         Words::tr("%1: %2.").arg(describe(sent->message), describeOutcome(*sent)));
    if (!acknowledged) return failed({.code = Errc::TimedOut, .subject = coach::wire::specOf(opcode).name});
    return {};
}

Outcome CoachPlay::end(Outcome outcome) {
    const bool began = radioOf(runner_).connections > 0;
    const bool stopped = runner_.finish();
    if (outcome && !stopped) {
        outcome = failed({.code = Errc::TimedOut, .subject = "stop"});
        outcome.error().text.remedy =
            Words::tr("Keep clear: the boat stops by itself within a second of its last velocity.");
    }
    if (!began) return outcome;
    QJsonObject facts{{QStringLiteral("stopped"), stopped},
                      {QStringLiteral("completed"), outcome.has_value()}};
    if (!outcome) facts[QStringLiteral("error")] = toJson(outcome.error());
    tell(QStringLiteral("end"), facts,
         stopped ? Words::tr("No boat is driven any more.")
                 : Words::tr(
                       "Whether the boat has stopped is not known; its own timer stops it within a second."));
    return outcome;
}

}  // namespace kickstand::ctl
