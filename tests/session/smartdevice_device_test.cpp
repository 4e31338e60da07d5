// One device, with a line that may be full.
#include <map>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/smartdevice/device.h"

namespace kickstand::smartdevice::testing {
namespace {

using namespace std::chrono_literals;

class SmartDeviceLine : public ::testing::Test, private SampleSink {
  protected:
    SmartDeviceLine() {
        DeviceHost host;
        host.send = [this](const wire::Message& message) {
            if (!isFull_) sent_.push_back(message);
            return !isFull_;
        };
        host.event = [this](const Event& event) { events_.push_back(event.kind); };
        host.answer = [this](CommandId id, Result<void> result) { answers_[id] = std::move(result); };
        host.changed = [] {};
        host.samples = this;
        const auto catalogue = makeCatalogue();
        device_ = std::make_unique<Device>(0, wire::Uid{}, catalogue->find("PolarBear"), std::move(host));
        device_->connected("port", now_);
    }
    template <class Message>
    std::ptrdiff_t count() const {
        return std::ranges::count_if(
            sent_, [](const wire::Message& one) { return std::holds_alternative<Message>(one); });
    }

    TimePoint now_{1s};
    void granted(wire::ParameterMask parameters, std::uint16_t delay_ms) {
        device_->message(wire::SubscriptionResponse{parameters, delay_ms, {}}, now_);
    }

    bool isFull_ = false;
    std::vector<wire::Message> sent_;
    std::vector<EventKind> events_;
    std::map<CommandId, Result<void>> answers_;
    std::unique_ptr<Device> device_;

  private:
    void sample(SignalId, TimePoint, float) override {}
    void gap(SignalId, TimePoint) override {}
};

TEST_F(SmartDeviceLine, AStopThatTheLineDoesNotTakeIsOwedUntilItDoes) {
    device_->write(1, {0, {{0, wire::Value(0.5F)}}}, now_);
    ASSERT_TRUE(device_->state().driving);
    isFull_ = true;
    device_->stop();
    device_->step(now_ += 10ms);
    EXPECT_TRUE(device_->owesStop());
    EXPECT_EQ(std::ranges::count(events_, EventKind::Stopped), 0);
    EXPECT_TRUE(device_->state().driving) << "nobody has told it to stop";
    EXPECT_FALSE(device_->state().disabled);
    isFull_ = false;
    device_->step(now_ += 10ms);
    EXPECT_FALSE(device_->owesStop());
    EXPECT_EQ(std::ranges::count(events_, EventKind::Stopped), 1);
    EXPECT_FALSE(device_->state().driving);
    EXPECT_TRUE(device_->state().disabled);
    EXPECT_EQ(count<wire::DeviceDisable>(), 1);
    EXPECT_EQ(count<wire::DeviceWrite>(), 2) << "the duty cycle, and zero";
}

TEST_F(SmartDeviceLine, AnAnswerToAnEarlierRequestForUpdatesIsNotTakenForThatToTheLast) {
    device_->subscribe(1, {0, 0x3, 40}, now_);
    // The answer to this one is that to the one before; it got lost itself.
    device_->subscribe(2, {0, 0x1, 100}, now_);
    granted(device_->state().spec->readable() & 0x3, 40);
    EXPECT_FALSE(answers_.contains(2));
    sent_.clear();
    device_->step(now_ += 500ms);
    EXPECT_EQ(count<wire::SubscriptionRequest>(), 1);
    granted(0x1, 100);
    ASSERT_TRUE(answers_.contains(2));
    EXPECT_TRUE(answers_[2]);
    EXPECT_EQ(device_->state().delay_ms, 100);
    sent_.clear();
    device_->step(now_ += 500ms);
    EXPECT_EQ(count<wire::SubscriptionRequest>(), 0);
}

TEST_F(SmartDeviceLine, WhatTheDeviceInsistsOnIsItsGrant) {
    device_->subscribe(1, {0, 0x1, 5}, now_);
    granted(0x1, 20);
    EXPECT_EQ(device_->state().delay_ms, 20) << "that is what it does now";
    device_->step(now_ += 500ms);
    granted(0x1, 20);
    ASSERT_TRUE(answers_.contains(1));
    EXPECT_TRUE(answers_[1]);
    sent_.clear();
    device_->step(now_ += 500ms);
    EXPECT_EQ(count<wire::SubscriptionRequest>(), 0);
    EXPECT_FALSE(device_->state().ungranted);
}

TEST_F(SmartDeviceLine, WhatTheLineDoesNotTakeWasNotWritten) {
    isFull_ = true;
    device_->write(1, {0, {{0, wire::Value(0.5F)}}}, now_);
    ASSERT_TRUE(answers_.contains(1));
    EXPECT_EQ(answers_[1].error().code, Errc::QueueFull);
    EXPECT_FALSE(device_->state().driving);
    EXPECT_FALSE(device_->state().parameters[0].written);
    EXPECT_EQ(device_->state().parameters[0].verdict, WriteVerdict::None);
    const auto disabled = device_->disable();
    ASSERT_FALSE(disabled);
    EXPECT_EQ(disabled.error().code, Errc::QueueFull);
    EXPECT_FALSE(device_->state().disabled);
}

}  // namespace
}  // namespace kickstand::smartdevice::testing
