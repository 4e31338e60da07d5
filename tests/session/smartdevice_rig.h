#pragma once

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/smartdevice/session.h"
#include "core/smartdevice/sim/simulated_ports.h"

namespace kickstand::smartdevice::testing {

using namespace std::chrono_literals;

/// A session and simulated boards in the time of a fake scheduler.
class SmartDeviceRig : public ::testing::Test, private SampleSink {
  protected:
    ~SmartDeviceRig() override {
        scheduler_.cancel(stepTimer_);
        session_.reset();
    }

    /// `devices` as in a sim: URI; `options_` are its other options. Runs until every board has answered.
    void start(const std::string& devices, const ByteFaultOptions& faults = {}, bool wait = true) {
        LinkUri uri{.scheme = "sim", .target = "smartdevice", .options = options_};
        uri.options["devices"] = devices;
        const auto options = sim::parseSimOptions(uri);
        ASSERT_TRUE(options);
        sim_ = std::make_unique<sim::SmartDeviceSim>(scheduler_, *options);
        makeSession(faults);
        if (!wait) return;
        ASSERT_TRUE(runUntil([this] { return live() == sim_->count(); }, 10s));
    }

    void makeSession(const ByteFaultOptions& faults = {}) {
        Session::Host host{scheduler_, stop_, *this, [this](const Event& event) { events_.push_back(event); },
                           [this](CommandId id, Result<void> result) {
                               EXPECT_FALSE(answers_.contains(id)) << "answered twice";
                               answers_[id] = std::move(result);
                           }};
        session_ = std::make_unique<Session>(
            std::move(host),
            SessionParts{sim::makeSimulatedPorts(scheduler_, *sim_, faults), catalogue_, "mine"});
        session_->start();
        if (stepTimer_ == 0) tick();
    }

    int live() const {
        const Snapshot now = session_->snapshot();
        return static_cast<int>(std::ranges::count(now.devices, Presence::Live, &DeviceState::presence));
    }
    DeviceState device(int number) const {
        return session_->snapshot().devices.at(static_cast<std::size_t>(number));
    }
    /// The device that a board of the simulator became.
    int numberOf(int board) const {
        const Snapshot now = session_->snapshot();
        for (const DeviceState& device : now.devices) {
            if (device.uid == sim_->board(board).uid()) return device.number;
        }
        return -1;
    }
    ParameterState parameter(int number, const char* name) const {
        const DeviceState state = device(number);
        return state.parameters.at(static_cast<std::size_t>(state.spec->find(name)));
    }

    CommandId execute(const Command& command) {
        session_->execute(++lastId_, command);
        return lastId_;
    }
    Result<void> perform(const Command& command) {
        const CommandId id = execute(command);
        EXPECT_TRUE(runUntil([&] { return answers_.contains(id); }, 2s)) << "never answered";
        return answers_[id];
    }
    Result<void> write(int number, const char* name, double value) {
        const DeviceState state = device(number);
        const int at = state.spec->find(name);
        const auto typed =
            wire::fromNumber(state.spec->parameters.at(static_cast<std::size_t>(at)).type, value);
        return perform(WriteValues{number, {{at, *typed}}});
    }
    void pressStop() {
        stop_.set(StopReason::Person);
        session_->halt();
    }

    void run(Duration span) { scheduler_.advance(span); }
    bool runUntil(const std::function<bool()>& done, Duration limit) {
        const TimePoint end = scheduler_.now() + limit;
        while (!done()) {
            if (scheduler_.now() >= end) return false;
            scheduler_.advance(10ms);
        }
        return true;
    }
    int count(EventKind kind) const {
        return static_cast<int>(std::ranges::count(events_, kind, &Event::kind));
    }

    FakeScheduler scheduler_;
    StopLatch stop_;
    std::unique_ptr<sim::SmartDeviceSim> sim_;
    std::unique_ptr<Session> session_;
    std::vector<Event> events_;
    std::map<CommandId, Result<void>> answers_;
    std::map<SignalId, int> samples_;
    std::string catalogue_;
    std::map<std::string, std::string> options_;
    bool heartbeatFresh_ = true;

  private:
    void tick() {
        stepTimer_ = scheduler_.callAfter(10ms, [this] {
            tick();
            if (session_) session_->step(scheduler_.now(), heartbeatFresh_);
        });
    }
    void sample(SignalId signal, TimePoint /*time*/, float /*value*/) override { ++samples_[signal]; }
    void gap(SignalId /*signal*/, TimePoint /*time*/) override {}

    CommandId lastId_ = 0;
    TimerId stepTimer_ = 0;
};

}  // namespace kickstand::smartdevice::testing
