// Pulls the plug of a busy session at seeded moments and puts it in again: the whole engine on a fake clock,
// sixteen simulated robots that drive, charge and kick behind a radio at its true pace. Each time every robot
// must have braked within 1.1 s, nothing may be done again after the reconnection, and nothing may move
// before a person says so. Prints one JSON object; exits 1 when something was not as it must be.
//
//     unplug [loopback|usbip] [MOMENTS] [SEED]
//
// Over USB/IP client and server talk through a connection in memory, and half of the moments cut that
// connection instead of pulling the plug.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string_view>
#include <vector>

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/message_packet.h"
#include "tests/soak/memory.h"
#include "tests/soak/soak_links.h"
#include "tests/support/session/session_rig.h"

namespace {

using namespace std::chrono_literals;
using namespace kickstand;
using namespace kickstand::thunderbots;
using kickstand::soak::SoakLinks;
using kickstand::testing::SessionRig;
using kickstand::testing::SessionRigOptions;

constexpr int kDefaultMoments = 1000;
/// The dongle loses power with its plug: from then on the robots' own time-out counts (protocol 6.1).
constexpr Duration kBrakedWithin = 1100ms;
/// How often the robots are looked at meanwhile.
constexpr Duration kLook = 5ms;
/// Longer than anything takes that is not broken.
constexpr Duration kPatience = 60s;
/// Longer than a kick takes that is done at all, or a robot without blocks to notice.
constexpr Duration kSettle = 1500ms;
/// A kick that left the dongle before it lost its power arrives within this.
constexpr Duration kInTheAir = 50ms;
/// Robots' and engine's own timers come and go: more than this many more is a leak.
constexpr std::size_t kTimersMayGrow = 40;
/// What the allocated memory may grow by from a quarter of the moments to the last.
constexpr double kMayGrow_MB = 1;
/// OUT and control transfers that a running session may have under way.
constexpr std::int64_t kMayWait = 8;
/// Kicks are told apart by their width: none twice to one robot at one moment.
constexpr int kFirstWidth = 5;
constexpr int kWidths = 120;

/// Watches what is handed to the host controller: transfers that never end, kicks that nobody gave.
class Watch final : public UsbTapObserver {
  public:
    void observe(const UsbTapRecord& record) override {
        if (record.kind == UsbTapRecord::Kind::Lost) kicksAtLoss_ = kicks_;
        if (isInEndpoint(record.endpoint) && !record.setup) return;
        if (record.kind == UsbTapRecord::Kind::Submitted) {
            ++underWay_;
            if (isKick(record)) ++kicks_;
        } else if (record.kind == UsbTapRecord::Kind::Completed) {
            --underWay_;
        }
    }
    std::int64_t underWay() const { return underWay_; }
    /// Kicks handed in since the link was lost for the last time.
    std::uint64_t kicksSinceLoss() const { return kicks_ - kicksAtLoss_; }

  private:
    static bool isKick(const UsbTapRecord& record) {
        if (record.endpoint != wire::address(wire::Endpoint::MessageOut)) return false;
        const auto message = wire::decodeMessagePacket(record.data, wire::Direction::Out);
        return message && message->pipe == wire::Pipe::Kick;
    }

    std::int64_t underWay_ = 0;
    std::uint64_t kicks_ = 0;
    std::uint64_t kicksAtLoss_ = 0;
};

/// Of one robot, at one moment.
struct Kicks {
    std::array<int, kWidths> given{};
    int count = 0;
    std::uint64_t doneBefore = 0;
};

struct Times {
    std::vector<double> noticed_ms;
    std::vector<double> reopened_ms;
    std::vector<double> braked_ms;
};

class Unplug {
  public:
    Unplug(bool overUsbip, int moments, std::uint64_t seed)
        : overUsbip_(overUsbip),
          moments_(moments),
          random_(seed),
          links_(overUsbip, static_cast<std::uint32_t>(seed)),
          rig_(options(seed)) {}

    /// The server's connections are to the simulated dongle, which goes with the rig.
    ~Unplug() { links_.cut(); }
    Unplug(const Unplug&) = delete;
    Unplug& operator=(const Unplug&) = delete;

    int run();

  private:
    SessionRigOptions options(std::uint64_t seed) {
        SessionRigOptions made;
        made.sim.seed = seed;
        made.keepPackets = false;
        made.observer = &watch_;
        made.makeLink = [this](UsbDeviceModel& device, Scheduler& scheduler) {
            return links_.make(device, scheduler);
        };
        return made;
    }

    bool moment();
    bool begin();
    void beBusy(Duration span);
    void act();
    void kick(int robot);
    void pull();
    void putIn();
    bool loseAndFind();
    bool allBraked() const;
    bool waitForRobots();
    void checkKicks();
    void checkQuiet();
    void look();
    bool report(double wall_s);
    void complain(const char* what);
    Duration anyTime(Duration least, Duration most) {
        return Duration(std::uniform_int_distribution<Duration::rep>(least.count(), most.count())(random_));
    }
    int any(int below) { return static_cast<int>(random_() % static_cast<std::uint64_t>(below)); }
    TimePoint now() { return rig_.scheduler().now(); }

    bool overUsbip_;
    int moments_;
    std::mt19937_64 random_;
    SoakLinks links_;
    Watch watch_;
    SessionRig rig_;

    int number_ = 0;
    TimePoint pulledAt_{};
    bool cut_ = false;  ///< This moment cuts the connection, and leaves the plug where it is.
    std::array<Kicks, kRobots> kicks_;
    std::uint64_t given_ = 0;
    std::uint64_t done_ = 0;
    std::uint64_t replayed_ = 0;
    std::uint64_t faults_ = 0;
    Times times_;
    std::array<std::size_t, 2> timers_{};  ///< The most that waited in the first quarter, and later.
    std::array<double, 2> memory_MB_{};    ///< After a quarter of the moments, and after the last.
};

void Unplug::complain(const char* what) {
    ++faults_;
    std::fprintf(stderr, "unplug: moment %d at %.6f s: %s\n", number_, seconds(now() - TimePoint()), what);
}

bool Unplug::begin() {
    rig_.rearm();
    rig_.advance(10ms);
    for (int robot = 0; robot < kRobots; ++robot)
        kicks_.at(static_cast<std::size_t>(robot)) = {{}, 0, rig_.robot(robot).kicks};
    return rig_.ask(ArmHighVoltage{kAllRobots, true}) && rig_.ask(SetCharger{kAllRobots, true}) &&
           rig_.ask(SetWheels{kAllRobots, {60, 60, -60, -60}});
}

void Unplug::beBusy(Duration span) {
    const TimePoint end = now() + span;
    while (now() < end) {
        act();
        rig_.advance(std::min(anyTime(1ms, 80ms), end - now()));
    }
}

void Unplug::act() {
    const int robot = any(kRobots);
    switch (any(4)) {
        case 0:
            rig_.give(SetWheels{maskOf(robot), {any(100), -any(100), any(100), 30}});
            break;
        case 1:
            rig_.give(SetDribbler{maskOf(robot), any(2) == 0});
            break;
        default:
            kick(robot);
            break;
    }
}

void Unplug::kick(int robot) {
    Kicks& kicks = kicks_.at(static_cast<std::size_t>(robot));
    if (kicks.count == kWidths) return;
    const auto width = static_cast<std::size_t>(kicks.count++);
    ++kicks.given.at(width);
    ++given_;
    rig_.give(Kick{robot, {true, true, static_cast<std::uint8_t>(kFirstWidth + width), 0, 0}});
}

void Unplug::pull() {
    cut_ = overUsbip_ && any(2) == 0;
    if (cut_) {
        links_.cut();
    } else {
        rig_.simulate("plugged", 0);
    }
}

void Unplug::putIn() {
    if (cut_) {
        links_.mend();
    } else {
        rig_.simulate("plugged", 1);
    }
}

bool Unplug::allBraked() const {
    for (int robot = 0; robot < kRobots; ++robot) {
        const auto report = rig_.robot(robot);
        if (report.driveFresh && report.lastDrive.run) return false;
    }
    return true;
}

/// From the pulled plug to a session that runs again. False when that never comes.
bool Unplug::loseAndFind() {
    const TimePoint pulledAt = now();
    const TimePoint putInAt = pulledAt + anyTime(1ms, 3s);
    const std::size_t connections = rig_.count(EventKind::Connected);
    bool braked = false;
    bool isIn = false;
    pull();
    // A person who has not noticed goes on: all of it must be refused, and none of it done later.
    for (int i = 0; i < 4; ++i)
        act();
    while (!isIn || !braked || rig_.count(EventKind::Connected) == connections) {
        if (now() - pulledAt > kPatience) return false;
        if (!isIn && now() >= putInAt) {
            isIn = true;
            putIn();
        }
        rig_.advance(isIn ? kLook : std::min(kLook, putInAt - now()));
        if (braked || !allBraked()) continue;
        braked = true;
        times_.braked_ms.push_back(1000 * seconds(now() - pulledAt));
        if (now() - pulledAt > kBrakedWithin + kLook) complain("a robot drove on for too long");
    }
    times_.reopened_ms.push_back(1000 * seconds(rig_.last(EventKind::Connected)->time - putInAt));
    const auto lost = rig_.last(EventKind::LinkLost);
    if (lost && lost->time >= pulledAt) {
        times_.noticed_ms.push_back(1000 * seconds(lost->time - pulledAt));
    } else {
        complain("nobody said that the link was lost");
    }
    pulledAt_ = pulledAt;
    return true;
}

/// Each kick was done at most once, and none after the robots had lost the dongle.
void Unplug::checkKicks() {
    for (int robot = 0; robot < kRobots; ++robot) {
        Kicks& kicks = kicks_.at(static_cast<std::size_t>(robot));
        const auto report = rig_.robot(robot);
        const std::uint64_t done = report.kicks - kicks.doneBefore;
        if (done > report.lastKicks.size()) return complain("more kicks than can be told apart");
        done_ += done;
        for (std::size_t i = report.lastKicks.size() - done; i < report.lastKicks.size(); ++i) {
            const auto& record = report.lastKicks[i];
            const int width = record.pulses[0].width_us / wire::kKickStep_us - kFirstWidth;
            const bool known = width >= 0 && width < kicks.count;
            const bool once = known && kicks.given.at(static_cast<std::size_t>(width))-- == 1;
            if (once && record.time <= pulledAt_ + kInTheAir) continue;
            ++replayed_;
            complain("a kick was done again, or late");
        }
    }
    if (watch_.kicksSinceLoss() != 0) complain("a kick was sent after the link was lost");
}

/// Nothing moves, charges or waits before a person says so.
void Unplug::checkQuiet() {
    for (int robot = 0; robot < kRobots; ++robot) {
        const auto report = rig_.robot(robot);
        if (!report.driveFresh || report.lastDrive != wire::brakedBlock())
            complain("a robot was told something else than to brake");
    }
    if (rig_.state().active()) complain("the session still wants something");
    if (!rig_.flows().stop.isSet()) complain("the loss did not latch STOP");
    if (!rig_.unanswered().empty()) complain("a command was never answered");
    if (watch_.underWay() > kMayWait) complain("transfers never ended");
}

/// What was used after a quarter of the moments is to do for the rest.
void Unplug::look() {
    const std::size_t at = number_ < moments_ / 4 ? 0 : 1;
    timers_.at(at) = std::max(timers_.at(at), rig_.scheduler().pending());
    memory_MB_.at(at) = soak::allocated_MB().value_or(0);
}

bool Unplug::moment() {
    if (!begin()) {
        complain("the session could not be set going");
        return false;
    }
    beBusy(anyTime(1ms, 2s));
    if (!loseAndFind() || !waitForRobots()) {
        complain("the session did not come back");
        return false;
    }
    rig_.advance(kSettle);
    checkKicks();
    checkQuiet();
    look();
    rig_.forget();
    return true;
}

bool Unplug::waitForRobots() {
    for (Duration waited{}; waited < kPatience; waited += 100ms) {
        if (rig_.isRunning()) return true;
        rig_.advance(100ms);
    }
    return false;
}

int Unplug::run() {
    const auto begin = std::chrono::steady_clock::now();
    if (!rig_.connect()) {
        std::fprintf(stderr, "unplug: the session did not start\n");
        return 1;
    }
    while (number_ < moments_ && moment())
        ++number_;
    return report(seconds(std::chrono::steady_clock::now() - begin)) ? 0 : 1;
}

void print(const char* name, std::vector<double>& samples) {
    if (samples.empty()) samples.push_back(0);
    std::ranges::sort(samples);
    const auto quantile = [&](double part) {
        return samples[static_cast<std::size_t>(part * static_cast<double>(samples.size() - 1))];
    };
    std::printf(" \"%s\": {\"p50\": %.1f, \"p99\": %.1f, \"max\": %.1f},\n", name, quantile(0.5),
                quantile(0.99), quantile(1));
}

bool Unplug::report(double wall_s) {
    const double grown_MB = memory_MB_[1] - memory_MB_[0];
    const bool few = moments_ < 8;  // Too few to tell growth from a start.
    const bool flat = few || (grown_MB <= kMayGrow_MB && timers_[1] <= timers_[0] + kTimersMayGrow);
    const bool ok = number_ == moments_ && faults_ == 0 && replayed_ == 0 && done_ > 0 && flat;
    std::printf("{\"soak\": \"unplug\", \"link\": \"%s\", \"ok\": %s, \"moments\": %d, \"wall_s\": %.1f,\n",
                overUsbip_ ? "usbip" : "loopback", ok ? "true" : "false", number_, wall_s);
    print("noticed_ms", times_.noticed_ms);
    print("reopened_ms", times_.reopened_ms);
    print("all_braked_ms", times_.braked_ms);
    std::printf(
        " \"kicks\": {\"asked_for\": %llu, \"done\": %llu, \"replayed\": %llu}, \"faults\": %llu,\n"
        " \"timers\": {\"quarter\": %zu, \"end\": %zu},\n"
        " \"allocated_MB\": {\"quarter\": %.1f, \"end\": %.1f, \"flat\": %s}}\n",
        static_cast<unsigned long long>(given_), static_cast<unsigned long long>(done_),
        static_cast<unsigned long long>(replayed_), static_cast<unsigned long long>(faults_), timers_[0],
        timers_[1], memory_MB_[0], memory_MB_[1], flat ? "true" : "false");
    return ok;
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view link = count > 1 ? arguments[1] : "loopback";
    const int moments = count > 2 ? std::atoi(arguments[2]) : kDefaultMoments;
    const std::uint64_t seed = count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1;
    if ((link != "loopback" && link != "usbip") || moments < 1) {
        std::fprintf(stderr, "usage: unplug [loopback|usbip] [MOMENTS] [SEED]\n");
        return 2;
    }
    return Unplug(link == "usbip", moments, seed).run();
}
