// The engine as a program uses it: its own thread, callers on others. Nothing here asserts how long anything
// takes; a watchdog ends what does not come.

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/engine/engine.h"
#include "core/link/loopback/loopback_usb_link.h"
#include "core/thunderbots/sim/thunderbots_sim.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using thunderbots::sim::ThunderbotsSim;

constexpr auto kWatchdog = 60s;

/// Links to simulated robots of their own.
class SimulatedLinks final : public LinkProvider {
  public:
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override {
        auto options = thunderbots::sim::parseSimOptions(uri);
        if (!options) return fail(options.error());
        auto sim = std::make_shared<ThunderbotsSim>(scheduler, *options);
        ProvidedUsbLink provided;
        provided.link = std::make_unique<LoopbackUsbLink>(scheduler, sim->device());
        provided.sim = &sim->control();
        provided.keepAlive = std::move(sim);
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([found = std::move(found)] { found({}); });
    }
};

LinkUri simulated() {
    return parseLinkUri("sim:thunderbots?robots=0-3&radio=ideal").value();
}

/// On a machine that is busy with other tests a caller may be late without being gone.
constexpr auto kPatience = 10s;

std::unique_ptr<Engine> makeEngine(Duration heartbeatLimit) {
    EngineOptions options;
    options.heartbeatLimit = heartbeatLimit;
    return std::make_unique<Engine>(std::make_unique<SimulatedLinks>(), options);
}

bool waitFor(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + kWatchdog;
    while (!done()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::yield();
    }
    return true;
}

const thunderbots::Snapshot* sessionIn(const EngineSnapshot& snapshot) {
    if (snapshot.sessions.empty()) return nullptr;
    return std::get_if<thunderbots::Snapshot>(&snapshot.sessions.front().system);
}

class EngineThreads : public ::testing::Test {
  protected:
    bool connect() {
        session = engine->connect(simulated()).value();
        return waitFor([this] {
            engine->heartbeat();
            const auto now = engine->snapshot();
            const auto* system = sessionIn(*now);
            return now->heartbeatFresh && system && system->link == thunderbots::LinkState::Running &&
                   system->robots[3].freshness == thunderbots::Freshness::Current;
        });
    }
    /// Hands a command in and waits for its answer; the one who takes answers.
    std::optional<Result<void>> ask(const thunderbots::Command& command) {
        const auto id = engine->submit(session, SystemCommand{command});
        if (!id) return fail(id.error());
        std::optional<Result<void>> result;
        waitFor([&] {
            engine->heartbeat();
            for (const Answer& answer : engine->takeAnswers()) {
                if (answer.id == *id) result = answer.result;
            }
            return result.has_value();
        });
        return result;
    }
    bool isDriven(std::size_t robot) {
        const auto now = engine->snapshot();
        const auto* system = sessionIn(*now);
        return system && system->robots.at(robot).told && system->robots.at(robot).told->run;
    }

    std::unique_ptr<Engine> engine = makeEngine(kPatience);
    SessionId session = 0;
};

TEST_F(EngineThreads, DrivesARobotAndStopsIt) {
    ASSERT_TRUE(connect());
    const auto driven = ask(thunderbots::SetWheels{1, {50, 50, 50, 50}});
    ASSERT_TRUE(driven);
    EXPECT_TRUE(*driven);
    EXPECT_TRUE(waitFor([this] {
        engine->heartbeat();
        return isDriven(0);
    }));
    engine->stop();
    EXPECT_TRUE(engine->isStopped()) << "latched before stop() returns";
    EXPECT_TRUE(waitFor([this] { return !isDriven(0); }));
    EXPECT_TRUE(engine->isStopped());
    engine->rearm();
    EXPECT_FALSE(engine->isStopped());
}

TEST_F(EngineThreads, ASilentCallerStopsTheRobots) {
    engine = makeEngine(EngineOptions{}.heartbeatLimit);
    ASSERT_TRUE(connect());
    const auto driven = ask(thunderbots::SetWheels{1, {50, 50, 50, 50}});
    ASSERT_TRUE(driven && *driven);
    EXPECT_TRUE(waitFor([this] { return engine->isStopped(); }));
    EXPECT_TRUE(waitFor([this] { return engine->snapshot()->stop == StopReason::HeartbeatStale; }));
    EXPECT_TRUE(waitFor([this] { return !isDriven(0); }));
}

TEST_F(EngineThreads, AnswersEachCommandOfManyThreadsOnce) {
    ASSERT_TRUE(connect());
    constexpr int kThreads = 4;
    constexpr int kEach = 200;
    std::mutex mutex;
    std::set<CommandId> given;
    std::vector<std::thread> callers;
    callers.reserve(kThreads);
    for (int i = 0; i < kThreads; ++i)
        callers.emplace_back([&, i] {
            for (int n = 0; n < kEach; ++n) {
                engine->heartbeat();
                const auto id = engine->submit(
                    session, SystemCommand{thunderbots::Command{thunderbots::SetWheels{
                                 thunderbots::maskOf(i), {n % 100, n % 100, n % 100, n % 100}}}});
                if (!id) continue;
                const std::lock_guard lock(mutex);
                given.insert(*id);
            }
        });
    for (std::thread& caller : callers)
        caller.join();
    std::multiset<CommandId> answered;
    EXPECT_TRUE(waitFor([&] {
        engine->heartbeat();
        for (const Answer& answer : engine->takeAnswers()) {
            if (given.contains(answer.id)) answered.insert(answer.id);
        }
        return answered.size() >= given.size();
    }));
    EXPECT_EQ(std::set<CommandId>(answered.begin(), answered.end()), given);
    EXPECT_EQ(answered.size(), given.size());
}

TEST_F(EngineThreads, StopsFromManyThreadsAtOnce) {
    ASSERT_TRUE(connect());
    std::vector<std::thread> callers;
    std::atomic<int> stopped{0};
    constexpr int kThreads = 6;
    callers.reserve(kThreads);
    for (int i = 0; i < kThreads; ++i)
        callers.emplace_back([&, i] {
            for (int n = 0; n < 200; ++n) {
                engine->heartbeat();
                if (i % 3 == 2) {
                    engine->rearm();
                    continue;
                }
                engine->stop(i % 3 == 0 ? StopReason::Person : StopReason::Suspend);
                ++stopped;
                static_cast<void>(engine->submit(
                    session, SystemCommand{thunderbots::Command{thunderbots::SetWheels{15, {9, 9, 9, 9}}}}));
                static_cast<void>(engine->snapshot()->stop);
            }
        });
    for (std::thread& caller : callers)
        caller.join();
    EXPECT_EQ(stopped, 4 * 200);
    engine->stop();
    EXPECT_TRUE(waitFor([this] {
        const auto now = engine->snapshot();
        return now->stop != StopReason::None && !isDriven(0) && !isDriven(3);
    }));
}

TEST_F(EngineThreads, EndsUnderLoad) {
    for (int round = 0; round < 5; ++round) {
        engine = makeEngine(kPatience);
        ASSERT_TRUE(connect());
        std::atomic<bool> ending{false};
        std::vector<std::thread> callers;
        constexpr int kThreads = 3;
        callers.reserve(kThreads);
        for (int i = 0; i < kThreads; ++i)
            callers.emplace_back([&, i] {
                std::uint64_t cursor = 0;
                while (!ending) {
                    engine->heartbeat();
                    static_cast<void>(engine->submit(
                        session,
                        SystemCommand{thunderbots::Command{thunderbots::SetWheels{15, {i, 10, 20, 30}}}}));
                    static_cast<void>(engine->readEvents(cursor));
                    static_cast<void>(engine->snapshotVersion());
                }
            });
        // Callers stop before the engine does, as the window that owns it sees to; what they asked for is
        // still under way.
        EXPECT_TRUE(waitFor([this] { return isDriven(0); }));
        ending = true;
        for (std::thread& caller : callers)
            caller.join();
        engine.reset();
    }
}

TEST_F(EngineThreads, EndsWhileALinkIsOpening) {
    session = engine->connect(simulated()).value();
    engine.reset();
}

TEST_F(EngineThreads, ShutsDownFromTwoThreadsAtOnce) {
    ASSERT_TRUE(connect());
    std::thread other([this] { engine->shutdown(); });
    engine->shutdown();
    other.join();
    const auto late = engine->connect(simulated());
    ASSERT_TRUE(late);
    EXPECT_TRUE(waitFor([this] {
        for (const Answer& answer : engine->takeAnswers()) {
            if (!answer.result && answer.result.error().code == Errc::NotConnected) return true;
        }
        return false;
    })) << "refused, not opened";
}

/// Holds the engine's thread until it is let go, as nothing real may.
class HeldLinks final : public LinkProvider {
  public:
    explicit HeldLinks(std::shared_future<void> letGo) : letGo_(std::move(letGo)) {}
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::BadUri, toString(uri));
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        letGo_.wait();
        scheduler.post([found = std::move(found)] { found({}); });
    }

  private:
    std::shared_future<void> letGo_;
};

TEST(EngineQueue, RefusesWhatItHasNoRoomForAndAnswersTheRest) {
    std::promise<void> letGo;
    Engine engine(std::make_unique<HeldLinks>(letGo.get_future().share()));
    std::set<CommandId> given;
    bool refused = false;
    for (int i = 0; i < 100'000 && !refused; ++i) {
        const auto id = engine.submit(0, Discover{});
        if (id) given.insert(*id);
        refused = !id && id.error().code == Errc::QueueFull;
    }
    EXPECT_TRUE(refused);
    // Never waits, whatever the engine's thread is at.
    engine.stop();
    EXPECT_TRUE(engine.isStopped());
    letGo.set_value();
    std::multiset<CommandId> answered;
    EXPECT_TRUE(waitFor([&] {
        for (const Answer& answer : engine.takeAnswers())
            answered.insert(answer.id);
        return answered.size() >= given.size();
    }));
    EXPECT_EQ(std::set<CommandId>(answered.begin(), answered.end()), given);
    EXPECT_EQ(answered.size(), given.size());
}

}  // namespace
}  // namespace kickstand
