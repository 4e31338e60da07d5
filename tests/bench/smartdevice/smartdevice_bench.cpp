// What COBS costs on frames of 64 bytes, one in twenty of them zero, against memcpy of the same bytes in the
// same run; and what a session with 32 boards that each send every 5 ms costs, as JSON on standard output.

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/framing/cobs.h"
#include "core/smartdevice/session.h"
#include "core/smartdevice/sim/simulated_ports.h"
#include "tests/bench/thunderbots/figures.h"

namespace {

using namespace kickstand;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kFrameBytes = 64;
constexpr std::size_t kFrames = 1024;  ///< Different ones, so that no branch is learnt by heart.
constexpr int kPasses = 50;            ///< Over all of them, for one sample.
constexpr int kSamples = 200;
constexpr int kBoards = 32;
constexpr int kSeconds = 10;

/// Makes the compiler believe that a value is looked at.
template <class T>
void use(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

using Data = std::array<std::uint8_t, kFrameBytes>;
using Encoding = std::array<std::uint8_t, cobsMost(kFrameBytes)>;

/// `work` does the frame of that number once.
template <class Work>
std::vector<double> times_ns(Work work) {
    std::vector<double> samples;
    for (int sample = 0; sample < kSamples; ++sample) {
        const auto begin = Clock::now();
        for (int pass = 0; pass < kPasses; ++pass) {
            for (std::size_t frame = 0; frame < kFrames; ++frame)
                work(frame);
        }
        const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
        samples.push_back(took.count() / (static_cast<double>(kPasses) * static_cast<double>(kFrames)));
    }
    return samples;
}

void print(const char* name, std::vector<double> samples, std::vector<double> copy) {
    std::printf("  \"%s\": {\"p50_ns\": %.2f, \"p99_ns\": %.2f, \"memcpy_p50_ns\": %.2f, \"ratio\": %.1f},\n",
                name, bench::quantile(samples, 0.5), bench::quantile(samples, 0.99),
                bench::quantile(copy, 0.5), bench::quantile(samples, 0.5) / bench::quantile(copy, 0.5));
}

void measureCobs() {
    std::mt19937 random(1);
    std::vector<Data> frames(kFrames);
    std::vector<Encoding> encodings(kFrames);
    std::vector<std::size_t> lengths(kFrames);
    for (std::size_t i = 0; i < kFrames; ++i) {
        for (std::uint8_t& byte : frames[i])
            byte = random() % 20 == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(1 + random() % 255);
        lengths[i] = cobsEncode(frames[i], encodings[i]);
    }
    // As a program copies what it got: how much that is, the compiler does not know.
    volatile std::size_t size = kFrameBytes;
    Encoding out{};
    const auto copy = times_ns([&](std::size_t i) {
        std::memcpy(out.data(), frames[i].data(), size);
        use(out);
    });
    const auto encode = times_ns([&](std::size_t i) {
        use(cobsEncode(frames[i], out));
        use(out);
    });
    const auto decode = times_ns([&](std::size_t i) {
        use(cobsDecode(ByteView(encodings[i]).first(lengths[i]), out));
        use(out);
    });
    print("cobs_encode", encode, copy);
    print("cobs_decode", decode, copy);
}

/// A sink that is as cheap as one can be.
class Counter final : public SampleSink {
  public:
    void sample(SignalId, TimePoint, float) override { ++count; }
    void gap(SignalId, TimePoint) override {}
    std::uint64_t count = 0;
};

/// The session's share cannot be had apart: the simulated boards and their lines are in it.
void measureSession() {
    using namespace smartdevice;
    FakeScheduler scheduler;
    StopLatch stop;
    Counter samples;
    sim::SmartDeviceSimOptions options;
    for (int i = 0; i < kBoards; ++i)
        options.boards.push_back({i % 2 == 0 ? "PolarBear" : "BatteryBuzzer", wire::Dialect::Current});
    sim::SmartDeviceSim boards(scheduler, options);
    Session::Host host{scheduler, stop, samples, [](const Event&) {}, [](CommandId, const Result<void>&) {}};
    auto session = std::make_unique<Session>(
        std::move(host), SessionParts{sim::makeSimulatedPorts(scheduler, boards), {}, {}});
    session->start();
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            scheduler.advance(std::chrono::milliseconds(10));
            session->step(scheduler.now(), true);
        }
    };
    run(200);
    for (int i = 0; i < kBoards; ++i)
        session->execute(static_cast<CommandId>(i + 1), Subscribe{i, 0xFFFF, 5});
    run(100);
    samples.count = 0;
    const std::clock_t begin = std::clock();
    run(kSeconds * 100);
    const double used_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::printf("  \"boards_32_at_5_ms\": {\"core_percent_with_simulators\": %.2f, \"values_per_s\": %.0f}\n",
                used_s * 100 / kSeconds, static_cast<double>(samples.count) / kSeconds);
}

}  // namespace

int main() {
    std::printf("{\n");
    measureCobs();
    measureSession();
    std::printf("}\n");
}
