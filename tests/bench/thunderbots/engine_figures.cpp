#include "tests/bench/thunderbots/engine_figures.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "core/engine/engine.h"
#include "core/link/tapped_usb_link.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/micropacket.h"
#include "tests/bench/thunderbots/figures.h"

namespace kickstand::bench {
namespace {

using namespace std::chrono_literals;
using namespace thunderbots;

/// Longer than anything takes that is not broken.
constexpr auto kPatience = 10s;
constexpr double kRobotFeedback_Hz = 200;
/// Set points in use: below what pulls a battery down until its robot locks itself out.
constexpr int kSpeeds = 200;

/// Watches for drive blocks: when every robot of a mask has been told a speed, or to brake. Engine thread,
/// but for expect() and await().
class BlockWatch final : public UsbTapObserver {
  public:
    /// Begins to watch for these robots being told that speed; 0 is a braked block.
    void expect(RobotMask robots, int speed) {
        const std::lock_guard lock(mutex_);
        doneAt_ = 0;
        speed_ = speed;
        missing_ = robots;
    }
    /// Waits for the last of them and gives the time at which the link took it.
    TimePoint await() {
        std::unique_lock lock(mutex_);
        if (!done_.wait_for(lock, kPatience, [this] { return doneAt_ != 0; })) {
            std::fprintf(stderr, "bench: a block did not come to the link\n");
            std::_Exit(1);
        }
        return TimePoint(Duration(doneAt_));
    }

    void observe(const UsbTapRecord& record) override {
        const bool taken =
            record.kind == UsbTapRecord::Kind::Completed && record.status == UsbStatus::Completed;
        if (!taken || record.setup || record.endpoint != wire::address(wire::Endpoint::StateOut)) return;
        const std::lock_guard lock(mutex_);
        wire::MicropacketReader reader(record.data, wire::Direction::Out);
        while (const auto next = reader.next()) {
            if (!*next) return;
            const auto block = wire::decodeDrive((*next)->payload);
            if (block && (block->run ? block->wheels[0] : 0) == speed_)
                missing_ &= static_cast<RobotMask>(~maskOf((*next)->robot));
        }
        if (missing_ != 0 || doneAt_ != 0) return;
        doneAt_ = record.time.time_since_epoch().count();
        done_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable done_;
    RobotMask missing_ = 0;
    int speed_ = 0;
    std::int64_t doneAt_ = 1;
};

/// Puts a tap around the links of somebody else.
class TappedLinks final : public LinkProvider {
  public:
    TappedLinks(const BenchedLink& benched, BlockWatch& watch) : benched_(benched), watch_(watch) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override {
        auto provided = benched_.make(uri, scheduler);
        if (!provided) return provided;
        auto tapped = std::make_unique<TappedUsbLink>(std::move(provided->link), scheduler);
        tapped->addObserver(&watch_);
        provided->link = std::move(tapped);
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([found = std::move(found)] { found({}); });
    }

  private:
    const BenchedLink& benched_;
    BlockWatch& watch_;
};

class EngineBench {
  public:
    explicit EngineBench(const BenchedLink& benched)
        : uri_(*parseLinkUri(benched.uri)), engine_(std::make_unique<TappedLinks>(benched, watch_)) {}
    ~EngineBench() {
        ending_ = true;
        heart_.join();
    }
    EngineBench(const EngineBench&) = delete;
    EngineBench& operator=(const EngineBench&) = delete;

    /// Connects and waits until the session runs and every robot has been heard; gives the time until it ran.
    double connect_ms() {
        const TimePoint begin = engine_.now();
        session_ = *engine_.connect(uri_);
        while (!reached(false))
            std::this_thread::sleep_for(500us);
        const double took_ms = 1000 * seconds(engine_.now() - begin);
        while (!reached(true))
            std::this_thread::sleep_for(1ms);
        return took_ms;
    }

    std::vector<double> commands_ms(RobotMask robots, int samples) {
        submit(SetWheelLimit{kFastestWheel});
        std::vector<double> took;
        took.reserve(static_cast<std::size_t>(samples));
        for (int i = 0; i < samples; ++i) {
            pause();
            took.push_back(drive_ms(robots, 1 + i % kSpeeds));
        }
        return took;
    }

    std::vector<double> stops_ms(int samples) {
        std::vector<double> took;
        took.reserve(static_cast<std::size_t>(samples));
        for (int i = 0; i < samples; ++i) {
            drive_ms(kAllRobots, 1 + i % kSpeeds);
            pause();
            watch_.expect(kAllRobots, 0);
            const TimePoint begin = engine_.now();
            engine_.stop();
            took.push_back(1000 * seconds(watch_.await() - begin));
            engine_.rearm();
        }
        return took;
    }

    /// Packets a second that came in over a while.
    double packetsIn_per_s() {
        const auto before = packetsIn();
        const TimePoint begin = engine_.now();
        std::this_thread::sleep_for(1s);
        return static_cast<double>(packetsIn() - before) / seconds(engine_.now() - begin);
    }

  private:
    double drive_ms(RobotMask robots, int speed) {
        watch_.expect(robots, speed);
        const TimePoint begin = engine_.now();
        submit(SetWheels{robots, {speed, speed, speed, speed}});
        return 1000 * seconds(watch_.await() - begin);
    }
    void submit(const thunderbots::Command& command) {
        if (!engine_.submit(session_, SystemCommand{command})) std::abort();
        static_cast<void>(engine_.takeAnswers());
    }
    /// As long as it takes to forget where in a frame of the bus it is.
    void pause() { std::this_thread::sleep_for(5ms + std::chrono::microseconds(random_() % 5000)); }
    /// The session's state; none before it has been published.
    std::optional<Snapshot> state() {
        const auto latest = engine_.snapshot();
        if (latest->sessions.empty() || !latest->heartbeatFresh) return std::nullopt;
        const auto* system = std::get_if<Snapshot>(&latest->sessions.front().system);
        return system ? std::optional(*system) : std::nullopt;
    }
    bool reached(bool heardAll) {
        const auto now = state();
        if (!now || now->link != LinkState::Running) return false;
        const auto heard = [](const RobotState& robot) { return robot.freshness == Freshness::Current; };
        return !heardAll || std::ranges::all_of(now->robots, heard);
    }
    std::uint64_t packetsIn() {
        const auto now = state();
        return now ? now->traffic.packetsIn : 0;
    }

    const LinkUri uri_;
    BlockWatch watch_;
    Engine engine_;
    SessionId session_ = 0;
    std::mt19937 random_{1};
    std::atomic<bool> ending_{false};
    std::thread heart_{[this] {
        while (!ending_) {
            engine_.heartbeat();
            std::this_thread::sleep_for(20ms);
        }
    }};
};

}  // namespace

int measureEngine(const BenchedLink& benched, int count, char** arguments) {
    const int samples = count > 1 ? std::atoi(arguments[1]) : benched.samples;
    if (samples < 1) {
        std::fprintf(stderr, "usage: %s [SAMPLES]\n", arguments[0]);
        return 2;
    }
    std::vector<double> starts;
    starts.reserve(static_cast<std::size_t>(benched.starts) + 1);
    for (int i = 0; i < benched.starts; ++i)
        starts.push_back(EngineBench(benched).connect_ms());
    EngineBench bench(benched);
    starts.push_back(bench.connect_ms());
    const double packetsIn_per_s = bench.packetsIn_per_s();
    auto all = bench.commands_ms(kAllRobots, samples);
    auto one = bench.commands_ms(maskOf(7), samples);
    auto stops = bench.stops_ms(samples);
    std::printf("{\n  \"feedback_Hz\": %.0f, \"packets_in_per_s\": %.0f,\n", kRobotFeedback_Hz,
                packetsIn_per_s);
    printFigures("command_to_16th_block_ms", all, ",");
    printFigures("command_to_one_robot_ms", one, ",");
    printFigures("stop_to_last_braked_block_ms", stops, ",");
    printFigures("start_to_running_ms", starts, "");
    std::printf("}\n");
    return 0;
}

}  // namespace kickstand::bench
