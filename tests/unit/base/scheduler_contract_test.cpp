#include <functional>
#include <future>
#include <memory>
#include <ostream>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/base/thread_scheduler.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;

/// A scheduler, and the way in which a test waits for what it does.
class SchedulerRig {
  public:
    virtual ~SchedulerRig() = default;
    virtual Scheduler& scheduler() = 0;
    /// Lets it work until `done` has been told. False when a watchdog had to end the wait.
    virtual bool runUntil(std::future<void> done) = 0;
    virtual void destroy() = 0;
};

class FakeRig final : public SchedulerRig {
  public:
    Scheduler& scheduler() override { return *scheduler_; }
    bool runUntil(std::future<void> done) override {
        return scheduler_->runUntil([&] { return done.wait_for(0s) == std::future_status::ready; }, 60s);
    }
    void destroy() override { scheduler_.reset(); }

  private:
    std::unique_ptr<FakeScheduler> scheduler_ = std::make_unique<FakeScheduler>();
};

class ThreadRig final : public SchedulerRig {
  public:
    Scheduler& scheduler() override { return *scheduler_; }
    bool runUntil(std::future<void> done) override { return done.wait_for(60s) == std::future_status::ready; }
    void destroy() override { scheduler_.reset(); }

  private:
    std::unique_ptr<ThreadScheduler> scheduler_ = std::make_unique<ThreadScheduler>();
};

struct RigFactory {
    const char* scheduler;
    std::unique_ptr<SchedulerRig> (*make)();
    friend void PrintTo(const RigFactory& factory, std::ostream* out) { *out << factory.scheduler; }
};

class SchedulerContract : public ::testing::TestWithParam<RigFactory> {
  protected:
    /// Tells runUntil() when it is called on the scheduler's thread, after all that was asked for before it.
    std::function<void()> finish() {
        return [this] { finished_.set_value(); };
    }
    [[nodiscard]] bool run() { return rig_->runUntil(finished_.get_future()); }
    /// Something that adds a number to the list.
    Scheduler::Callback note(int number) {
        return [this, number] { order_.push_back(number); };
    }

    std::promise<void> finished_;
    std::vector<int> order_;
    // Last: its thread ends before what it works on does.
    std::unique_ptr<SchedulerRig> rig_ = GetParam().make();
    Scheduler& scheduler_ = rig_->scheduler();
};

TEST_P(SchedulerContract, PostsRunInOrder) {
    std::vector<int> expected;
    for (int i = 0; i < 100; ++i) {
        scheduler_.post(note(i));
        expected.push_back(i);
    }
    scheduler_.post(finish());
    ASSERT_TRUE(run());
    EXPECT_EQ(order_, expected);
}

TEST_P(SchedulerContract, CallsRunInTheOrderOfTheirTimes) {
    const TimePoint start = scheduler_.now() + 5ms;
    scheduler_.callAt(start + 3ms, note(3));
    scheduler_.callAt(start + 1ms, note(1));
    scheduler_.callAt(start + 2ms, note(2));
    scheduler_.callAt(start + 4ms, finish());
    ASSERT_TRUE(run());
    EXPECT_EQ(order_, (std::vector<int>{1, 2, 3}));
}

TEST_P(SchedulerContract, CallsOfOneTimeRunInTheOrderTheyWereAskedFor) {
    const TimePoint when = scheduler_.now() + 5ms;
    for (int i = 0; i < 20; ++i)
        scheduler_.callAt(when, note(i));
    scheduler_.callAt(when, finish());
    ASSERT_TRUE(run());
    std::vector<int> expected(20);
    for (int i = 0; i < 20; ++i)
        expected[static_cast<std::size_t>(i)] = i;
    EXPECT_EQ(order_, expected);
}

TEST_P(SchedulerContract, NothingRunsBeforeItsTime) {
    const TimePoint when = scheduler_.now() + 2ms;
    TimePoint ran{};
    scheduler_.callAt(when, [&] {
        ran = scheduler_.now();
        finished_.set_value();
    });
    ASSERT_TRUE(run());
    EXPECT_GE(ran, when);
}

TEST_P(SchedulerContract, ATimeThatHasPassedMeansSoonButNeverInsideTheCall) {
    scheduler_.post([this] {
        scheduler_.callAt(scheduler_.now() - 1h, [this] {
            order_.push_back(2);
            finished_.set_value();
        });
        order_.push_back(1);
    });
    ASSERT_TRUE(run());
    EXPECT_EQ(order_, (std::vector<int>{1, 2}));
}

TEST_P(SchedulerContract, APostInsideACallbackRunsAfterIt) {
    scheduler_.post([this] {
        scheduler_.post([this] {
            order_.push_back(2);
            finished_.set_value();
        });
        order_.push_back(1);
    });
    ASSERT_TRUE(run());
    EXPECT_EQ(order_, (std::vector<int>{1, 2}));
}

TEST_P(SchedulerContract, ACancelledCallDoesNotRun) {
    const TimePoint when = scheduler_.now() + 20ms;
    const TimerId cancelled = scheduler_.callAt(when, note(1));
    const TimerId kept = scheduler_.callAt(when, note(2));
    EXPECT_NE(cancelled, 0U);
    EXPECT_NE(cancelled, kept);
    EXPECT_TRUE(scheduler_.cancel(cancelled));
    EXPECT_FALSE(scheduler_.cancel(cancelled)) << "it is not pending any more";
    scheduler_.callAt(when, finish());
    ASSERT_TRUE(run());
    EXPECT_EQ(order_, std::vector<int>{2});
    EXPECT_FALSE(scheduler_.cancel(kept)) << "it has run";
    EXPECT_FALSE(scheduler_.cancel(0));
    EXPECT_FALSE(scheduler_.cancel(kept + 1000));
}

TEST_P(SchedulerContract, ACallMayCancelTheNextAndNotItself) {
    const TimePoint when = scheduler_.now() + 5ms;
    bool self = true;
    bool next = false;
    TimerId first = 0;
    TimerId second = 0;
    scheduler_.post([&] {
        first = scheduler_.callAt(when, [&] {
            self = scheduler_.cancel(first);
            next = scheduler_.cancel(second);
        });
        second = scheduler_.callAt(when, note(2));
        scheduler_.callAt(when, finish());
    });
    ASSERT_TRUE(run());
    EXPECT_FALSE(self);
    EXPECT_TRUE(next);
    EXPECT_TRUE(order_.empty());
}

TEST_P(SchedulerContract, AStreamOfPostsStarvesNoTimer) {
    std::function<void()> again = [&] { scheduler_.post(again); };
    bool stop = false;
    // In fake time a stream without end would stand still; it pauses after a while, as a real one is slow.
    int posts = 0;
    again = [&] {
        if (stop) return;
        if (++posts % 100 == 0)
            scheduler_.callAfter(1ms, again);
        else
            scheduler_.post(again);
    };
    scheduler_.callAfter(3ms, [&] {
        stop = true;
        finished_.set_value();
    });
    scheduler_.post(again);
    ASSERT_TRUE(run());
}

TEST_P(SchedulerContract, WhatIsPendingAtItsEndIsDroppedUnrun) {
    auto witness = std::make_shared<int>(0);
    const std::weak_ptr<int> watched = witness;
    scheduler_.callAfter(1h, [witness] { ++*witness; });
    witness.reset();
    EXPECT_FALSE(watched.expired());
    rig_->destroy();
    EXPECT_TRUE(watched.expired()) << "the callback was leaked";
}

TEST_P(SchedulerContract, ACallbackIsForgottenOnceItHasRun) {
    auto witness = std::make_shared<int>(0);
    const std::weak_ptr<int> watched = witness;
    bool forgotten = false;
    scheduler_.post([witness = std::move(witness)] { ++*witness; });
    scheduler_.post([&] {
        forgotten = watched.expired();
        finished_.set_value();
    });
    ASSERT_TRUE(run());
    EXPECT_TRUE(forgotten);
}

INSTANTIATE_TEST_SUITE_P(Schedulers, SchedulerContract,
                         ::testing::Values(RigFactory{"fake",
                                                      +[]() -> std::unique_ptr<SchedulerRig> {
                                                          return std::make_unique<FakeRig>();
                                                      }},
                                           RigFactory{"thread", +[]() -> std::unique_ptr<SchedulerRig> {
                                                          return std::make_unique<ThreadRig>();
                                                      }}));

TEST(FakeScheduler, TimePassesOnlyWhenATestSaysSo) {
    FakeScheduler scheduler;
    const TimePoint start = scheduler.now();
    std::vector<Duration> ran;
    std::function<void()> tick = [&] {
        ran.push_back(scheduler.now() - start);
        scheduler.callAfter(10ms, tick);
    };
    scheduler.callAfter(10ms, tick);
    scheduler.advance(9ms);
    EXPECT_TRUE(ran.empty());
    scheduler.advance(21ms);
    EXPECT_EQ(ran, (std::vector<Duration>{10ms, 20ms, 30ms}));
    EXPECT_EQ(scheduler.now() - start, 30ms);
    EXPECT_EQ(scheduler.pending(), 1U);
}

TEST(FakeScheduler, RunUntilStopsAtItsLimit) {
    FakeScheduler scheduler;
    bool late = false;
    scheduler.callAfter(2s, [&] { late = true; });
    EXPECT_FALSE(scheduler.runUntil([&] { return late; }, 1s));
    EXPECT_EQ(scheduler.now(), TimePoint(1s));
    EXPECT_TRUE(scheduler.runUntil([&] { return late; }, 1s));
}

TEST(FakeScheduler, RunPendingLetsNoTimePass) {
    FakeScheduler scheduler;
    int posts = 0;
    int timers = 0;
    scheduler.post([&] { scheduler.post([&] { ++posts; }); });
    scheduler.callAfter(1ns, [&] { ++timers; });
    scheduler.runPending();
    EXPECT_EQ(posts, 1);
    EXPECT_EQ(timers, 0);
}

TEST(ThreadScheduler, TakesPostsFromManyThreadsAndLosesNone) {
    constexpr int kThreads = 4;
    constexpr int kPosts = 2000;
    std::vector<int> last(kThreads, -1);
    std::promise<void> finished;
    int received = 0;
    bool ordered = true;
    ThreadScheduler scheduler;
    std::vector<std::thread> threads;
    threads.reserve(kThreads);
    for (int t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < kPosts; ++i) {
                scheduler.post([&, t, i] {
                    auto& before = last[static_cast<std::size_t>(t)];
                    ordered = ordered && before == i - 1 && scheduler.isCurrent();
                    before = i;
                    if (++received == kThreads * kPosts) finished.set_value();
                });
            }
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    ASSERT_EQ(finished.get_future().wait_for(60s), std::future_status::ready);
    EXPECT_TRUE(ordered) << "posts of one thread were reordered, or ran elsewhere";
    EXPECT_FALSE(scheduler.isCurrent());
}

TEST(ThreadScheduler, CallsAreCancelledFromOtherThreads) {
    ThreadScheduler scheduler;
    std::atomic<int> ran{0};
    int cancelled = 0;
    constexpr int kCalls = 500;
    for (int i = 0; i < kCalls; ++i) {
        const TimerId id = scheduler.callAfter(i % 2 == 0 ? 1h : 10us, [&] { ++ran; });
        cancelled += scheduler.cancel(id) ? 1 : 0;
    }
    std::promise<void> finished;
    scheduler.callAfter(5ms, [&] { finished.set_value(); });
    ASSERT_EQ(finished.get_future().wait_for(60s), std::future_status::ready);
    EXPECT_EQ(ran + cancelled, kCalls) << "each either ran or was cancelled";
}

TEST(ThreadScheduler, AnEarlierCallOvertakesTheOneThatIsWaitedFor) {
    std::promise<void> finished;
    ThreadScheduler scheduler;
    scheduler.callAfter(1h, [] {});
    scheduler.callAfter(1ms, [&] { finished.set_value(); });
    EXPECT_EQ(finished.get_future().wait_for(60s), std::future_status::ready);
}

TEST(ThreadScheduler, ItsEndWaitsForTheCallThatRuns) {
    std::promise<void> started;
    std::promise<void> release;
    bool ended = false;
    std::thread releaser;
    {
        ThreadScheduler scheduler;
        scheduler.post([&, released = release.get_future().share()] {
            started.set_value();
            released.wait();
            ended = true;
        });
        started.get_future().wait();
        releaser = std::thread([&] { release.set_value(); });
    }
    EXPECT_TRUE(ended);
    releaser.join();
}

}  // namespace
}  // namespace kickstand
