// What decoding one drive block and one feedback block costs, as JSON on standard output. The peer is memcpy
// of the same bytes in the same run.

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/feedback.h"
#include "tests/bench/thunderbots/figures.h"

namespace {

using namespace kickstand;
using namespace kickstand::thunderbots;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kBlocks = 1024;  ///< Different ones, so that no branch is learnt by heart.
constexpr int kPasses = 200;           ///< Over all of them, for one sample.
constexpr int kSamples = 200;

/// Makes the compiler believe that a value is looked at.
template <class T>
void use(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

template <class Bytes, class Work>
std::vector<double> times_ns(const std::vector<Bytes>& blocks, Work work) {
    std::vector<double> samples;
    for (int sample = 0; sample < kSamples; ++sample) {
        const auto begin = Clock::now();
        for (int pass = 0; pass < kPasses; ++pass) {
            for (const Bytes& block : blocks)
                work(block);
        }
        const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
        samples.push_back(took.count() / (static_cast<double>(kPasses) * static_cast<double>(blocks.size())));
    }
    return samples;
}

template <class Bytes>
std::vector<double> memcpy_ns(const std::vector<Bytes>& blocks) {
    return times_ns(blocks, [](const Bytes& block) {
        Bytes copy;
        std::memcpy(copy.data(), block.data(), block.size());
        use(copy);
    });
}

void print(const char* name, std::vector<double> decode, std::vector<double> copy, const char* end) {
    std::printf(
        "  \"%s\": {\"p50_ns\": %.2f, \"p99_ns\": %.2f, \"memcpy_p50_ns\": %.2f, \"ratio\": %.1f}%s\n", name,
        bench::quantile(decode, 0.5), bench::quantile(decode, 0.99), bench::quantile(copy, 0.5),
        bench::quantile(decode, 0.5) / bench::quantile(copy, 0.5), end);
}

}  // namespace

int main() {
    std::mt19937 random(1);
    std::vector<std::array<std::uint8_t, wire::kDriveBytes>> drives;
    std::vector<std::array<std::uint8_t, wire::kFeedbackBytes>> feedbacks;
    while (drives.size() < kBlocks) {
        wire::DriveBlock block;
        block.run = random() % 2 == 0;
        block.charge = random() % 2 == 0;
        for (std::int16_t& wheel : block.wheels)
            wheel = static_cast<std::int16_t>(static_cast<int>(random() % 2047) - 1023);
        drives.push_back(*wire::encodeDrive(block));
        wire::FeedbackBlock feedback;
        feedback.valid = true;
        feedback.battery_adc = static_cast<std::uint16_t>(random() % 1024);
        feedback.capacitor_adc = static_cast<std::uint16_t>(random() % 4096);
        feedback.thermistor_adc = static_cast<std::uint16_t>(random() % 1024);
        feedback.light_adc = static_cast<std::uint16_t>(random() % 1024);
        feedbacks.push_back(*wire::encodeFeedback(feedback));
    }
    std::printf("{\n");
    print("drive_block", times_ns(drives, [](const auto& bytes) { use(wire::decodeDrive(bytes)); }),
          memcpy_ns(drives), ",");
    print("feedback_block", times_ns(feedbacks, [](const auto& bytes) { use(wire::decodeFeedback(bytes)); }),
          memcpy_ns(feedbacks), "");
    std::printf("}\n");
}
