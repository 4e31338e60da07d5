#include "core/thunderbots/parameter_service.h"

#include <chrono>
#include <utility>

#include "core/base/hex.h"

namespace kickstand::thunderbots {

namespace {

/// By then a robot that has answered the request to reboot has gone, and is not back yet (protocol 6.8).
constexpr Duration kProofPause = std::chrono::seconds(1);
/// A robot that has not answered after so many seconds will not.
constexpr int kProofTries = 60;

}  // namespace

ParameterService::ParameterService(Scheduler& scheduler, RobotRequests& requests,
                                   std::function<void(const Event&)> event)
    : scheduler_(scheduler), requests_(requests), event_(std::move(event)) {
    requests_.setListener(
        [this](int robot, const wire::FirmwareResponse& response) { heard(robot, response); });
}

ParameterService::~ParameterService() {
    for (const Proof& proof : proofs_)
        scheduler_.cancel(proof.timer);
}

void ParameterService::raise(EventKind kind, int robot, std::int64_t code, std::int64_t previous,
                             std::string text) {
    event_(Event{kind, scheduler_.now(), robot, code, previous, 0, std::move(text)});
}

void ParameterService::ask(int robot, const wire::FirmwareRequest& request, Done done,
                           RobotRequests::Gate still) {
    const auto answered = [done](Result<wire::FirmwareResponse> response) {
        done(response ? Result<void>() : fail(std::move(response.error())));
    };
    auto asked = requests_.ask(robot, request, answered, std::move(still));
    if (asked) return;
    scheduler_.post([done = std::move(done), error = std::move(asked.error())] { done(fail(error)); });
}

void ParameterService::heard(int robot, const wire::FirmwareResponse& response) {
    if (const auto* read = std::get_if<wire::ReadParametersResponse>(&response)) {
        readHeard(robot, read->parameters);
    } else if (const auto* signatures = std::get_if<wire::ReadSignaturesResponse>(&response)) {
        keeper_.signaturesRead(robot, *signatures, scheduler_.now());
        raise(EventKind::SignaturesRead, robot, signatures->microcontrollerCrc, signatures->flashCrc);
    } else if (std::holds_alternative<wire::EraseChipResponse>(response)) {
        keeper_.erased(robot);
    } else if (std::holds_alternative<wire::RebootResponse>(response)) {
        keeper_.willReboot(robot);
        raise(EventKind::RobotRebooting, robot);
        proofs_[static_cast<std::size_t>(robot)].tries = kProofTries;
        proveSoon(robot);
    }
}

void ParameterService::readHeard(int robot, const wire::OperationalParameters& parameters) {
    const bool proofDue = keeper_.proofDue(robot);
    keeper_.read(robot, parameters, scheduler_.now());
    raise(EventKind::ParametersRead, robot, 0, 0, toHex(wire::encodeParameters(parameters).view()));
    if (!proofDue) return;
    const bool proven = keeper_.state(robot).standing == ParameterStanding::Proven;
    raise(EventKind::ParametersProven, robot, proven ? 1 : 0);
}

void ParameterService::read(int robot, Done done) {
    ask(robot, wire::ReadParametersRequest{}, std::move(done));
}

void ParameterService::readSignatures(int robot, Done done) {
    ask(robot, wire::ReadSignaturesRequest{}, std::move(done));
}

void ParameterService::apply(int robot, const wire::OperationalParameters& parameters, const Done& done) {
    // Whether it was set, only the robot's own word can tell.
    const auto readAgain = [this, robot, parameters, done](Result<void> set) {
        if (!set) {
            done(std::move(set));
            return;
        }
        read(robot, [this, robot, parameters, done](Result<void> read) {
            if (read && keeper_.state(robot).robot != parameters) {
                Error error;
                error.code = Errc::NotVerified;
                error.robot = robot;
                read = fail(std::move(error));
            }
            if (read) {
                keeper_.applied(robot);
                raise(EventKind::ParametersApplied, robot);
            }
            done(std::move(read));
        });
    };
    ask(robot, wire::SetParametersRequest{parameters}, readAgain);
}

void ParameterService::commit(int robot, Done done) {
    ask(robot, wire::CommitParametersRequest{}, [this, robot, done = std::move(done)](Result<void> result) {
        if (result) {
            keeper_.committed(robot);
            raise(EventKind::ParametersCommitted, robot);
        }
        done(std::move(result));
    });
}

void ParameterService::reboot(int robot, RobotRequests::Gate still, Done done) {
    ask(robot, wire::RebootRequest{}, std::move(done), std::move(still));
}

void ParameterService::found(int robot) {
    if (!keeper_.proofDue(robot)) return;
    proofs_[static_cast<std::size_t>(robot)].tries = kProofTries;
    prove(robot);
}

void ParameterService::proveSoon(int robot) {
    TimerId& timer = proofs_[static_cast<std::size_t>(robot)].timer;
    scheduler_.cancel(timer);
    timer = scheduler_.callAfter(kProofPause, [this, robot] { prove(robot); });
}

void ParameterService::prove(int robot) {
    // A robot that is found again at once is never reported as lost (protocol 3.2).
    keeper_.rebootedUnseen(robot);
    if (!keeper_.proofDue(robot) || --proofs_[static_cast<std::size_t>(robot)].tries < 0) return;
    read(robot, [this, robot](const Result<void>& result) {
        if (!result) proveSoon(robot);
    });
}

}  // namespace kickstand::thunderbots
