// A day of sixteen robots in minutes: the whole engine on a fake clock, simulated robots behind a radio at
// its true pace that loses one frame in twenty, and a kick every second. Every kick given must be done
// exactly once, and memory must stay as it is. Prints one JSON object; exits 1 when something was not as it
// must be.
//
//     thunderbots_day [HOURS] [SEED]

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/soak/memory.h"
#include "tests/support/session/session_rig.h"

namespace {

using namespace std::chrono_literals;
using namespace kickstand;
using namespace kickstand::thunderbots;
using kickstand::testing::SessionRig;
using kickstand::testing::SessionRigOptions;

constexpr double kLoss = 0.05;
constexpr double kDefaultHours = 24;
/// What the allocated memory may grow by from a quarter of the time to its end.
constexpr double kMayGrow_MB = 1;
/// Dongle error-queue codes 41-56: a message could not be delivered to robot 0-15 (protocol 7.2).
constexpr std::int64_t kSendFailedFirst = 41;
/// Longer than any kick takes that arrives at all.
constexpr Duration kSettle = 10s;

/// What happened to the kicks of one robot.
struct Kicks {
    std::uint64_t given = 0;         ///< Taken by the dongle.
    std::uint64_t notDelivered = 0;  ///< The dongle said that it could not deliver them.
    std::uint64_t done = 0;          ///< By the robot.
};

class Day {
  public:
    Day(double hours, std::uint64_t seed) : hours_(hours), rig_(options(seed)) {}

    int run();

  private:
    static SessionRigOptions options(std::uint64_t seed) {
        SessionRigOptions made;
        made.sim.weather.loss = kLoss;
        made.sim.seed = seed;
        made.keepPackets = false;
        return made;
    }

    bool prepare();
    void second(std::int64_t number);
    void readEvents();
    /// Sees that every kick given to a robot so far was done once: long after the last one, before the next.
    void compare(int robot);
    int report(double wall_s);

    double hours_;
    SessionRig rig_;
    std::array<Kicks, kRobots> kicks_;
    std::array<TimePoint, kRobots> kickedAt_{};
    std::vector<double> latencies_ms_;
    std::uint64_t refused_ = 0;
    std::uint64_t unanswered_ = 0;
    std::uint64_t mismatches_ = 0;  ///< Looks at a robot that had not done each kick once.
    std::uint64_t lostRobots_ = 0;
    std::array<double, 3> allocated_MB_{};  ///< At the start, after a quarter, at the end.
    std::array<double, 3> resident_MB_{};
};

bool Day::prepare() {
    if (!rig_.connect()) return false;
    return rig_.ask(ArmHighVoltage{kAllRobots, true}) && rig_.ask(SetCharger{kAllRobots, true}) &&
           rig_.ask(SetWheels{kAllRobots, {40, 40, -40, -40}});
}

void Day::second(std::int64_t number) {
    const auto robot = static_cast<int>(number % kRobots);
    const auto steps = static_cast<std::uint8_t>(20 + number % 60);
    compare(robot);
    const TimePoint given = rig_.scheduler().now();
    const CommandId id = rig_.give(Kick{robot, {true, true, steps, 0, 0}});
    rig_.advance(1s);
    const auto answer = rig_.answer(id);
    if (!answer) {
        ++unanswered_;
    } else if (!*answer) {
        ++refused_;
    } else {
        ++kicks_.at(static_cast<std::size_t>(robot)).given;
    }
    readEvents();
    const auto records = rig_.robot(robot).lastKicks;
    if (!records.empty() && records.back().time >= given)
        latencies_ms_.push_back(1000 * seconds(records.back().time - given));
}

void Day::compare(int robot) {
    const Kicks& kicks = kicks_.at(static_cast<std::size_t>(robot));
    const auto report = rig_.robot(robot);
    if (report.kicks - report.automaticKicks + kicks.notDelivered != kicks.given) ++mismatches_;
}

void Day::readEvents() {
    for (const Event& event : rig_.events()) {
        if (event.kind == EventKind::RobotLost) ++lostRobots_;
        const std::int64_t failed = event.code - kSendFailedFirst;
        if (event.kind == EventKind::DongleFault && failed >= 0 && failed < kRobots)
            ++kicks_.at(static_cast<std::size_t>(failed)).notDelivered;
    }
    rig_.forget();
}

int Day::run() {
    const auto begin = std::chrono::steady_clock::now();
    if (!prepare()) {
        std::fprintf(stderr, "thunderbots_day: the session did not start\n");
        return 1;
    }
    const auto length_s = static_cast<std::int64_t>(hours_ * 3600);
    latencies_ms_.reserve(static_cast<std::size_t>(length_s));
    const std::array<std::int64_t, 3> looks{std::min<std::int64_t>(length_s / 20, 60), length_s / 4,
                                            length_s - 1};
    for (std::int64_t number = 0; number < length_s; ++number) {
        second(number);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            if (number != looks.at(i)) continue;
            allocated_MB_.at(i) = soak::allocated_MB().value_or(0);
            resident_MB_.at(i) = soak::resident_MB();
        }
    }
    rig_.advance(kSettle);
    readEvents();
    for (int robot = 0; robot < kRobots; ++robot) {
        const auto report = rig_.robot(robot);
        kicks_.at(static_cast<std::size_t>(robot)).done = report.kicks - report.automaticKicks;
    }
    return report(seconds(std::chrono::steady_clock::now() - begin));
}

int Day::report(double wall_s) {
    Kicks all;
    bool exact = true;
    for (const Kicks& one : kicks_) {
        all.given += one.given;
        all.notDelivered += one.notDelivered;
        all.done += one.done;
        exact = exact && one.done == one.given && mismatches_ == 0;
    }
    std::ranges::sort(latencies_ms_);
    const auto quantile = [this](double part) {
        if (latencies_ms_.empty()) return 0.0;
        return latencies_ms_[static_cast<std::size_t>(part * static_cast<double>(latencies_ms_.size() - 1))];
    };
    const double grown_MB = allocated_MB_[2] - allocated_MB_[1];
    const bool flat = grown_MB <= kMayGrow_MB;
    const Snapshot now = rig_.state();
    // A robot that is lost, or a kick that is refused, would leave the rest of the day with nothing to show.
    const bool ok = exact && flat && unanswered_ == 0 && refused_ == 0 && lostRobots_ == 0 && all.given > 0 &&
                    now.link == LinkState::Running;
    std::printf(
        "{\"soak\": \"thunderbots-day\", \"ok\": %s, \"hours\": %.3f, \"wall_s\": %.1f, \"loss\": %.2f,\n"
        " \"kicks\": {\"given\": %llu, \"done_once\": %llu, \"not_delivered_and_reported\": %llu, "
        "\"refused\": %llu, "
        "\"unanswered\": %llu, \"exactly_once\": %s},\n"
        " \"kick_ms\": {\"p50\": %.1f, \"p99\": %.1f, \"max\": %.1f},\n"
        " \"packets\": {\"out\": %llu, \"in\": %llu, \"malformed\": %llu}, \"robots_lost\": %llu,\n"
        " \"memory_MB\": {\"start\": %.1f, \"quarter\": %.1f, \"end\": %.1f, \"allocated_grown\": %.1f, "
        "\"flat\": %s}}\n",
        ok ? "true" : "false", hours_, wall_s, kLoss, static_cast<unsigned long long>(all.given),
        static_cast<unsigned long long>(all.done), static_cast<unsigned long long>(all.notDelivered),
        static_cast<unsigned long long>(refused_), static_cast<unsigned long long>(unanswered_),
        exact ? "true" : "false", quantile(0.5), quantile(0.99), quantile(1),
        static_cast<unsigned long long>(now.traffic.packetsOut),
        static_cast<unsigned long long>(now.traffic.packetsIn),
        static_cast<unsigned long long>(now.traffic.malformed), static_cast<unsigned long long>(lostRobots_),
        resident_MB_[0], resident_MB_[1], resident_MB_[2], grown_MB, flat ? "true" : "false");
    return ok ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    const double hours = count > 1 ? std::strtod(arguments[1], nullptr) : kDefaultHours;
    const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
    if (!(hours > 0.01 && hours <= 1000)) {
        std::fprintf(stderr, "usage: thunderbots_day [HOURS, from 0.02 to 1000] [SEED]\n");
        return 2;
    }
    return Day(hours, seed).run();
}
