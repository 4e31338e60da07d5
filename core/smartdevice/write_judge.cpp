#include "core/smartdevice/write_judge.h"

#include <chrono>

namespace kickstand::smartdevice {
namespace {

constexpr Duration kLongest = std::chrono::milliseconds(250);

constexpr wire::ParameterMask bit(int parameter) {
    return static_cast<wire::ParameterMask>(1U << parameter);
}

}  // namespace

void WriteJudge::begin(CommandId id, std::map<int, wire::Value> values,
                       const std::vector<ParameterState>& parameters, TimePoint now) {
    // Of a parameter that is written again before it was judged, only the last counts.
    for (Flight& flight : flights_) {
        for (const auto& [parameter, value] : values)
            flight.open.erase(parameter);
    }
    Flight flight;
    flight.id = id;
    flight.end.id = id;
    flight.deadline = now + kLongest;
    for (const auto& [parameter, value] : values) {
        flight.mask = static_cast<wire::ParameterMask>(flight.mask | bit(parameter));
        flight.before[parameter] = parameters.at(static_cast<std::size_t>(parameter)).value;
    }
    flight.open = std::move(values);
    flights_.push_back(std::move(flight));
    removeEnded();
}

void WriteJudge::data(wire::ParameterMask mask, Role role, const std::vector<ParameterState>& parameters) {
    bool answers = role == Role::Answer;
    for (Flight& flight : flights_) {
        take(flight, mask, parameters);
        // A device that took nothing answers with nothing in it, and a long answer comes in pieces.
        const bool within = (mask & ~flight.mask) == 0;
        const bool more = !flight.hasAnswer || (mask != 0 && (mask & flight.answered) == 0);
        if (answers && within && more) {
            flight.hasAnswer = true;
            flight.answered = static_cast<wire::ParameterMask>(flight.answered | mask);
            answers = false;
        } else if (flight.hasAnswer && role == Role::SampleEnd) {
            judgeRest(flight);
        }
    }
    removeEnded();
}

void WriteJudge::take(Flight& flight, wire::ParameterMask mask,
                      const std::vector<ParameterState>& parameters) {
    for (auto entry = flight.open.begin(); entry != flight.open.end();) {
        const auto& [parameter, value] = *entry;
        const auto& told = parameters.at(static_cast<std::size_t>(parameter)).value;
        const bool came = (mask & bit(parameter)) != 0 && told.has_value();
        if (came) flight.last.insert_or_assign(parameter, *told);
        const bool isThere = came && *told == value;
        if (isThere) judgements_.push_back({parameter, WriteVerdict::Done});
        entry = isThere ? flight.open.erase(entry) : std::next(entry);
    }
}

void WriteJudge::note(Flight& flight, int parameter, WriteVerdict verdict) {
    judgements_.push_back({parameter, verdict});
    if (verdict == WriteVerdict::Refused && flight.end.firstRefused < 0) flight.end.firstRefused = parameter;
    if (verdict == WriteVerdict::Unconfirmed && flight.end.firstSilent < 0)
        flight.end.firstSilent = parameter;
}

WriteVerdict WriteJudge::verdictOf(const Flight& flight, int parameter) {
    if (flight.hasAnswer)
        return (flight.answered & bit(parameter)) != 0 ? WriteVerdict::Changed : WriteVerdict::Refused;
    // Without an answer of its own only the samples are left to go by: the old value means that it was left,
    // and from silence nothing follows. Where nobody knows the old one, the missing answer has to do.
    const auto last = flight.last.find(parameter);
    if (last == flight.last.end()) return WriteVerdict::Unconfirmed;
    const auto& before = flight.before.at(parameter);
    return before && *before != last->second ? WriteVerdict::Changed : WriteVerdict::Refused;
}

void WriteJudge::judgeRest(Flight& flight) {
    for (const auto& [parameter, value] : flight.open)
        note(flight, parameter, verdictOf(flight, parameter));
    flight.open.clear();
}

void WriteJudge::step(TimePoint now) {
    for (Flight& flight : flights_) {
        if (now >= flight.deadline) judgeRest(flight);
    }
    removeEnded();
}

std::vector<CommandId> WriteJudge::abandon() {
    std::vector<CommandId> ids;
    for (const Flight& flight : flights_)
        ids.push_back(flight.id);
    flights_.clear();
    return ids;
}

void WriteJudge::removeEnded() {
    std::erase_if(flights_, [this](const Flight& flight) {
        if (flight.open.empty()) ended_.push_back(flight.end);
        return flight.open.empty();
    });
}

}  // namespace kickstand::smartdevice
