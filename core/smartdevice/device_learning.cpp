// Finding out what a board of an unknown kind has.

#include <chrono>
#include <utility>

#include "core/smartdevice/device.h"

namespace kickstand::smartdevice {
namespace {

constexpr int kReads = 2;
constexpr Duration kAnswerLimit = std::chrono::milliseconds(100);
constexpr int kHighestBit = wire::kMostParameters - 1;

constexpr wire::ParameterMask bit(int parameter) {
    return static_cast<wire::ParameterMask>(1U << parameter);
}

}  // namespace

void Device::learnNext(TimePoint now) {
    if (++learning_ > kHighestBit) return endLearning(now);
    learningReadsLeft_ = kReads;
    askLearning(now);
}

void Device::askLearning(TimePoint now) {
    learnUntil_ = now + kAnswerLimit;
    host_.send(wire::DeviceRead{bit(learning_)});
}

void Device::learned(const wire::DeviceData& message, TimePoint now) {
    const bool answers = message.parameters == bit(learning_) && !message.values.empty() &&
                         message.values.size() <= wire::kWidestValue;
    if (!answers) return;
    // What lies between cannot be read; it stays without a width.
    while (static_cast<int>(learnt_.parameters.size()) <= learning_) {
        ParameterSpec spec;
        spec.name = "parameter" + std::to_string(learnt_.parameters.size());
        spec.access = Access::Write;
        learnt_.parameters.push_back(std::move(spec));
    }
    learnt_.parameters.back().access = Access::ReadWrite;
    learnt_.parameters.back().rawWidth = static_cast<std::uint8_t>(message.values.size());
    learnNext(now);
}

void Device::endLearning(TimePoint now) {
    learning_ = -1;
    state_.learning = false;
    state_.spec = std::make_shared<const DeviceSpec>(learnt_);
    state_.parameters.assign(learnt_.parameters.size(), ParameterState{});
    state_.wanted = state_.spec->readable();
    askForUpdates(now);
    host_.changed();
}

}  // namespace kickstand::smartdevice
