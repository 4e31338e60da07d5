// What reading and writing XBee API frames of 64 bytes, one in twenty of them zero, costs, as JSON on
// standard output. The peer is memcpy of the same bytes in the same run.

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include "core/framing/xbee_parser.h"
#include "tests/bench/thunderbots/figures.h"

namespace {

using namespace kickstand;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kFrameBytes = 64;
constexpr std::size_t kFrames = 1024;  ///< Different ones, so that no branch is learnt by heart.
constexpr int kPasses = 50;            ///< Over all of them, for one sample.
constexpr int kSamples = 200;

/// Makes the compiler believe that a value is looked at.
template <class T>
void use(const T& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

using Data = std::array<std::uint8_t, kFrameBytes>;

/// `work` does all frames once.
template <class Work>
std::vector<double> times_ns(Work work) {
    std::vector<double> samples;
    for (int sample = 0; sample < kSamples; ++sample) {
        const auto begin = Clock::now();
        for (int pass = 0; pass < kPasses; ++pass)
            work();
        const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
        samples.push_back(took.count() / (static_cast<double>(kPasses) * static_cast<double>(kFrames)));
    }
    return samples;
}

std::vector<double> read_ns(const std::vector<Data>& frames, xbee::ApiMode mode) {
    std::vector<std::uint8_t> stream;
    for (const Data& data : frames) {
        const xbee::LineFrame line = xbee::wrapFrame(data, mode);
        stream.insert(stream.end(), line.begin(), line.end());
    }
    xbee::Parser parser(mode);
    return times_ns([&] {
        ByteView input = stream;
        for (ByteView data = parser.next(input); !data.empty(); data = parser.next(input))
            use(data);
    });
}

std::vector<double> write_ns(const std::vector<Data>& frames, xbee::ApiMode mode) {
    return times_ns([&] {
        for (const Data& data : frames)
            use(xbee::wrapFrame(data, mode));
    });
}

void print(const char* name, std::vector<double> samples, std::vector<double> copy, const char* end) {
    std::printf(
        "  \"%s\": {\"p50_ns\": %.2f, \"p99_ns\": %.2f, \"memcpy_p50_ns\": %.2f, \"ratio\": %.1f}%s\n", name,
        bench::quantile(samples, 0.5), bench::quantile(samples, 0.99), bench::quantile(copy, 0.5),
        bench::quantile(samples, 0.5) / bench::quantile(copy, 0.5), end);
}

}  // namespace

int main() {
    std::mt19937 random(1);
    std::vector<Data> frames(kFrames);
    for (Data& data : frames) {
        for (std::uint8_t& byte : data)
            byte = random() % 20 == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(1 + random() % 255);
    }
    // As a program copies what it got: how much that is, the compiler does not know.
    volatile std::size_t size = kFrameBytes;
    const auto copy = times_ns([&] {
        for (const Data& data : frames) {
            Data copied;
            std::memcpy(copied.data(), data.data(), size);
            use(copied);
        }
    });
    std::printf("{\n");
    print("read_plain", read_ns(frames, xbee::ApiMode::Plain), copy, ",");
    print("write_plain", write_ns(frames, xbee::ApiMode::Plain), copy, ",");
    print("read_escaped", read_ns(frames, xbee::ApiMode::Escaped), copy, ",");
    print("write_escaped", write_ns(frames, xbee::ApiMode::Escaped), copy, "");
    std::printf("}\n");
}
