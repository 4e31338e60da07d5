#include "core/engine/diagnosis_serial.h"

#include <algorithm>
#include <iterator>

#include "core/motionplan/wire/nxt_status.h"

namespace kickstand {
namespace {

using thunderbots::LinkState;

/// A serial port and the link over it, whichever system they are of.
struct Line {
    const LinkUri& uri;
    std::string port;
    std::optional<Error> error;
    LinkState link = LinkState::Idle;
};

/// Where the link stands, in the words that every link has.
template <class State>
LinkState standing(State link) {
    if (link == State::Running) return LinkState::Running;
    if (link == State::Searching) return LinkState::Searching;
    if (link == State::Failed) return LinkState::Failed;
    return link == State::Idle ? LinkState::Idle : LinkState::Opening;
}

/// The first check that an error is about.
Check about(const Error& error) {
    switch (error.code) {
        case Errc::NoDevice:
        case Errc::Disconnected:
            return Check::Device;
        case Errc::PermissionDenied:
            return Check::Permission;
        case Errc::ClaimedElsewhere:
            return Check::Claim;
        default:
            return Check::Link;
    }
}

/// What comes before an error is in order, and what comes after it was not looked at.
std::vector<Finding> upToTheLink(const Line& line) {
    std::vector<Finding> findings;
    CheckState state = CheckState::Ok;
    for (const Check check : {Check::Device, Check::Permission, Check::Claim, Check::Link}) {
        // What is simulated has no port that could be missing.
        if (check != Check::Link && line.uri.isSimulated()) continue;
        Finding found;
        found.check = check;
        found.link = line.uri;
        found.port = line.port;
        found.serial = true;
        found.linkState = line.link;
        if (line.error && about(*line.error) == check) {
            found.state = CheckState::Problem;
            found.error = line.error;
            state = CheckState::NotChecked;
        } else {
            found.state = state;
            if (state == CheckState::Ok && check == Check::Link && line.link != LinkState::Running)
                found.state = CheckState::Warning;
        }
        findings.push_back(std::move(found));
    }
    return findings;
}

/// The whole: `answers` is what is said where the link runs.
std::vector<Finding> withAnswers(const Line& line, Finding answers) {
    std::vector<Finding> findings = upToTheLink(line);
    answers.check = Check::Answers;
    answers.serial = true;
    answers.port = line.port;
    if (line.link != LinkState::Running) answers.state = CheckState::NotChecked;
    findings.push_back(std::move(answers));
    return findings;
}

std::string portOf(const LinkUri& uri, const ByteLinkInfo& info) {
    return info.port.empty() ? uri.target : info.port;
}

}  // namespace

std::vector<Finding> diagnoseSerial(const LinkUri& uri, const motionplan::Snapshot& state) {
    Finding answers;
    answers.answerer = Answerer::Nxt;
    if (!state.answers) {
        answers.state = CheckState::Problem;
    } else if (state.nxtStatus == motionplan::wire::kStatusNoProgram) {
        const auto status = motionplan::wire::nxtStatus(state.nxtStatus);
        answers.state = CheckState::Problem;
        answers.error = Error{.code = Errc::NxtRefused, .got = status.code, .detail = status.text};
    }
    return withAnswers({uri, portOf(uri, state.port), state.error, standing(state.link)}, std::move(answers));
}

std::vector<Finding> diagnoseSerial(const LinkUri& uri, const coach::Snapshot& state) {
    Finding answers;
    answers.answerer = Answerer::Radio;
    Line line{uri, portOf(uri, state.port), state.error, standing(state.link)};
    if (state.link == coach::LinkState::NoModule) {
        answers.state = CheckState::Problem;
        answers.error = Error{.code = Errc::RadioNotReady};
        line.link = LinkState::Running;
    }
    return withAnswers(line, std::move(answers));
}

std::vector<Finding> diagnoseSerial(const LinkUri& uri, const smartdevice::Snapshot& state) {
    std::vector<Finding> findings;
    for (const smartdevice::PortState& port : state.ports) {
        if (!port.error) continue;
        auto more = upToTheLink({uri, port.name, port.error, LinkState::Failed});
        // The link as a whole stands below; of a port only what is wrong with it matters.
        if (about(*port.error) != Check::Link) more.pop_back();
        findings.insert(findings.end(), std::make_move_iterator(more.begin()),
                        std::make_move_iterator(more.end()));
    }
    const bool missing =
        !uri.isSimulated() && !uri.target.empty() &&
        std::ranges::find(state.ports, uri.target, &smartdevice::PortState::name) == state.ports.end();
    if (missing) {
        const Error none{.code = Errc::NoDevice, .port = uri.target};
        findings = upToTheLink({uri, uri.target, none, LinkState::Searching});
        findings.pop_back();
    }
    const auto live =
        std::ranges::count(state.devices, smartdevice::Presence::Live, &smartdevice::DeviceState::presence);
    Finding link;
    link.check = Check::Link;
    link.link = uri;
    link.serial = true;
    link.linkState = standing(state.link);
    link.state = link.linkState == LinkState::Running ? CheckState::Ok : CheckState::Warning;
    findings.push_back(std::move(link));
    Finding answers;
    answers.check = Check::Answers;
    answers.serial = true;
    answers.answerer = Answerer::Board;
    answers.answering = static_cast<int>(live);
    answers.state = live > 0 ? CheckState::Ok : missing ? CheckState::NotChecked : CheckState::Problem;
    findings.push_back(std::move(answers));
    if (state.catalogueError) {
        Finding catalogue;
        catalogue.check = Check::Catalogue;
        catalogue.state = CheckState::Warning;
        catalogue.error = state.catalogueError;
        findings.push_back(std::move(catalogue));
    }
    return findings;
}

}  // namespace kickstand
