#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "core/coach/session.h"

namespace kickstand::coach {
namespace {

constexpr std::size_t kLongestSeries = 8;

std::string hexAddress(std::uint16_t address) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "0x%04X", unsigned{address});
    return text.data();
}

std::int64_t changesBetween(const RadioSettings& a, const RadioSettings& b) {
    return (a.address != b.address ? 1 : 0) + (a.channel != b.channel ? 1 : 0) + (a.pan != b.pan ? 1 : 0) +
           (a.mode != b.mode ? 1 : 0) + (a.baud != b.baud ? 1 : 0) + (a.name != b.name ? 1 : 0);
}

}  // namespace

void Session::execute(CommandId id, const Command& command) {
    if (ending_) {
        host_.answer(id, fail(Errc::NotConnected));
        return;
    }
    ++version_;
    std::visit([this, id](const auto& one) { perform(id, one); }, command);
}

Result<void> Session::checkRadio() const {
    if (state_ == LinkState::Running) return {};
    if (state_ == LinkState::NoModule) return fail(Errc::RadioNotReady);
    if (state_ == LinkState::Setting) return fail(Errc::RequestPending);
    return fail(Errc::NotConnected);
}

Result<void> Session::checkRole(wire::Role role, Team team) const {
    if (auto ready = checkRadio(); !ready) return ready;
    if (coach_.state() != CoachState::Off || towrp_.state() != TowrpState::Off)
        return fail(Errc::RoleRunning);
    if (radio_->settings.address != wire::addressOf(role, team))
        return fail(Errc::RadioNotSet,
                    (role == wire::Role::Coach ? "COACH " : "TOWRP ") + std::to_string(int{team}),
                    hexAddress(radio_->settings.address));
    return {};
}

Result<void> Session::checkSetup() const {
    if (state_ == LinkState::Setting) return fail(Errc::RequestPending);
    if (state_ != LinkState::Running && state_ != LinkState::NoModule) return fail(Errc::NotConnected);
    if (coach_.state() != CoachState::Off || coach_.stopWaits() || towrp_.state() != TowrpState::Off)
        return fail(Errc::RoleRunning);
    return {};
}

void Session::perform(CommandId id, const StartCoach& command) {
    auto may = checkRole(wire::Role::Coach, command.team);
    if (may) coach_.begin(command.team, command.color);
    host_.answer(id, std::move(may));
}

void Session::perform(CommandId id, const StartTowrp& command) {
    auto may = checkRole(wire::Role::Towrp, command.team);
    if (may) towrp_.begin(command.team);
    host_.answer(id, std::move(may));
}

void Session::perform(CommandId id, const EndRole&) {
    endRole(Unpairing::RoleEnded);
    host_.answer(id, {});
}

void Session::perform(CommandId id, const Pair& command) {
    auto may = checkRadio();
    host_.answer(id, may ? coach_.pair(command.boat) : std::move(may));
}

void Session::perform(CommandId id, const Steer& command) {
    if (command.velocity.isZero()) mustPassZero_ = false;
    Result<void> result;
    if (auto ready = checkRadio(); !ready) {
        result = std::move(ready);
    } else if (host_.stop.isSet() && !command.velocity.isZero()) {
        result = fail(Errc::StopLatched);
    } else if (coach_.state() == CoachState::Paired && command.held && mustPassZero_) {
        result = fail(Errc::MustPassZero);
    } else {
        result = coach_.steer(command.velocity);
    }
    host_.answer(id, std::move(result));
}

void Session::perform(CommandId id, const FreeDigital&) {
    auto may = host_.stop.isSet() ? Result<void>(fail(Errc::StopLatched)) : checkRadio();
    host_.answer(id, may ? coach_.freeDigital() : std::move(may));
}

void Session::perform(CommandId id, const FreeAnalog& command) {
    auto may = host_.stop.isSet() ? Result<void>(fail(Errc::StopLatched)) : checkRadio();
    host_.answer(id, may ? coach_.freeAnalog(command.percent) : std::move(may));
}

void Session::perform(CommandId id, const Suppress&) {
    auto may = checkRadio();
    host_.answer(id, may ? coach_.suppress() : std::move(may));
}

void Session::perform(CommandId id, const Act& command) {
    auto may = checkRadio();
    host_.answer(id, may ? coach_.act(command.action, series_.size()) : std::move(may));
}

void Session::perform(CommandId id, const SetSeries& command) {
    const auto& actions = command.actions;
    const bool named = std::none_of(actions.begin(), actions.end(),
                                    [](const std::string& action) { return action.empty(); });
    if (actions.empty() || actions.size() > kLongestSeries || !named) {
        host_.answer(id, fail(Errc::BadArgument, "series"));
        return;
    }
    series_ = actions;
    host_.answer(id, {});
}

void Session::perform(CommandId id, const Jettison&) {
    auto may = checkRadio();
    host_.answer(id, may ? coach_.jettison() : std::move(may));
}

void Session::perform(CommandId id, const SetMorale& command) {
    auto may = checkRadio();
    host_.answer(id, may ? towrp_.setMorale(command.morale) : std::move(may));
}

void Session::perform(CommandId id, const FindRadio&) {
    if (auto may = checkSetup(); !may) {
        host_.answer(id, std::move(may));
        return;
    }
    const Baud baud = radio_ ? radio_->settings.baud : port_.baud;
    settingFor_ = id;
    enter(LinkState::Setting);
    setup_.find(baud, [this, id](const Result<FoundRadio>& radio) {
        setUp(id, radio, EventKind::RadioFound, EventKind::RadioNotFound, 0);
    });
}

void Session::perform(CommandId id, const ApplyRadio& command) {
    auto may = checkSetup();
    if (may && !radio_) may = fail(Errc::RadioNotReady);
    if (may) may = checkSettings(command.settings);
    if (!may) {
        host_.answer(id, std::move(may));
        return;
    }
    const std::int64_t changes = changesBetween(radio_->settings, command.settings);
    settingFor_ = id;
    enter(LinkState::Setting);
    setup_.apply(radio_->settings, command.settings, [this, id, changes](const Result<FoundRadio>& radio) {
        setUp(id, radio, EventKind::RadioApplied, EventKind::RadioFailed, changes);
    });
}

void Session::setUp(CommandId id, const Result<FoundRadio>& radio, EventKind done, EventKind failed,
                    std::int64_t changes) {
    settingFor_ = 0;
    // After a failure it is not known what the module is set to, unless nothing was said to it.
    if (radio) {
        radio_ = *radio;
    } else if (radio.error().code != Errc::Unsupported) {
        radio_.reset();
    }
    const bool frames = radio_ && radio_->settings.mode != ModuleMode::Transparent;
    enter(frames ? LinkState::Running : LinkState::NoModule);
    if (radio) {
        port_.baud = radio->settings.baud;
        if (frames) ++connections_;
        const bool found = done == EventKind::RadioFound;
        raise(done, -1, found ? std::int64_t{radio->settings.baud} : std::int64_t{radio->settings.address},
              changes);
    } else {
        raise(failed, -1, static_cast<std::int64_t>(radio.error().code), 0, radio.error().subject);
    }
    host_.answer(id, radio ? Result<void>() : fail(radio.error()));
}

}  // namespace kickstand::coach
