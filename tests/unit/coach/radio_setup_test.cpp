#include "core/coach/radio_setup.h"

#include <array>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/coach/sim/xbee_sim.h"
#include "core/link/paced/paced_byte_link.h"

namespace kickstand::coach {
namespace {

using sim::ModuleMemory;

/// A line whose port does not have every speed.
class PickyLink final : public ByteLink {
  public:
    PickyLink(Scheduler& scheduler, ByteDeviceModel& module)
        : scheduler_(scheduler), link_(scheduler, module, {"sim", "module", 9600, {}}) {}

    void open(std::function<void(Result<ByteLinkInfo>)> done) override { link_.open(std::move(done)); }
    void close(std::function<void()> done) override { link_.close(std::move(done)); }
    Result<void> write(ByteView bytes) override { return link_.write(bytes); }
    std::size_t waiting() const override { return link_.waiting(); }
    void setBaud(Baud baud, std::function<void(Result<void>)> done) override {
        if (baud != lacks) return link_.setBaud(baud, std::move(done));
        scheduler_.post([done = std::move(done)] { done(fail(Errc::Io)); });
    }
    void setReceiver(std::function<void(ByteView)> receiver) override {
        link_.setReceiver(std::move(receiver));
    }
    void setPresenceListener(std::function<void(bool)> listener) override {
        link_.setPresenceListener(std::move(listener));
    }

    Baud lacks = 0;

  private:
    Scheduler& scheduler_;
    PacedByteLink link_;
};

/// A module on a line, and what looks for it.
struct Bench {
    explicit Bench(ModuleMemory memory) : module(scheduler, medium, std::move(memory), 0x0013A20012345678) {
        link.open([](const Result<ByteLinkInfo>&) {});
        scheduler.advance(std::chrono::milliseconds(10));
    }

    Result<FoundRadio> find(Baud first = 9600) {
        std::optional<Result<FoundRadio>> result;
        setup.find(first, [&](Result<FoundRadio> found) { result = std::move(found); });
        scheduler.runUntil([&] { return result.has_value(); }, std::chrono::minutes(2));
        return result ? *result : fail(Errc::Io);
    }
    Result<FoundRadio> apply(const RadioSettings& present, const RadioSettings& wanted) {
        std::optional<Result<FoundRadio>> result;
        setup.apply(present, wanted, [&](Result<FoundRadio> found) { result = std::move(found); });
        scheduler.runUntil([&] { return result.has_value(); }, std::chrono::minutes(2));
        return result ? *result : fail(Errc::Io);
    }

    FakeScheduler scheduler;
    sim::RadioMedium medium{scheduler, 1};
    sim::XbeeSim module;
    PickyLink link{scheduler, module};
    RadioLine line{scheduler,
                   link,
                   {[](const Received&) {},
                    [this](const xbee::AtResponse& response) { setup.client().response(response); },
                    [this](ByteView bytes) { setup.client().text(bytes); }, [](std::uint8_t) {}}};
    RadioSetup setup{scheduler, link, line};
};

ModuleMemory memoryOf(int mode, Baud baud) {
    ModuleMemory memory;
    memory.address = 0x1234;
    memory.mode = static_cast<std::uint8_t>(mode);
    memory.baudCode = baudCode(baud);
    memory.name = "before";
    return memory;
}

TEST(XbeeSim, ItsCommandModeLeavesNoTimerBehind) {
    FakeScheduler scheduler;
    sim::RadioMedium medium{scheduler, 1};
    {
        sim::XbeeSim module(scheduler, medium, memoryOf(0, 9600), 1);
        module.lineOpened(9600);
        for (int i = 0; i < 3; ++i) {
            scheduler.advance(std::chrono::milliseconds(1100));
            module.hostSent(std::array<std::uint8_t, 3>{'+', '+', '+'});
            scheduler.advance(std::chrono::milliseconds(1100));
            module.hostSent(std::array<std::uint8_t, 5>{'A', 'T', 'C', 'N', '\r'});
        }
    }
    EXPECT_EQ(scheduler.pending(), 0U);
}

class RadioSetupAt : public ::testing::TestWithParam<std::tuple<int, Baud>> {};

TEST_P(RadioSetupAt, FindsAndReadsTheModule) {
    const auto [mode, baud] = GetParam();
    Bench bench(memoryOf(mode, baud));
    const auto found = bench.find();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->settings,
              (RadioSettings{0x1234, 0x0C, 0x3332, static_cast<ModuleMode>(mode), baud, "before"}));
    EXPECT_EQ(found->identity.serial, 0x0013A20012345678U);
}

TEST_P(RadioSetupAt, MakesItTheRadioOfACoach) {
    const auto [mode, baud] = GetParam();
    Bench bench(memoryOf(mode, baud));
    const auto found = bench.find(baud);
    ASSERT_TRUE(found);
    const RadioSettings wanted = presetFor(wire::Role::Coach, 7, found->settings);
    const auto applied = bench.apply(found->settings, wanted);
    ASSERT_TRUE(applied) << name(applied.error().code) << ' ' << applied.error().subject;
    EXPECT_EQ(applied->settings, wanted);
    EXPECT_EQ(bench.module.memory().address, 0xBC07) << "it lasts";
    EXPECT_EQ(bench.module.memory().mode, 1);
    EXPECT_EQ(bench.module.memory().baudCode, 3U);
    EXPECT_EQ(bench.module.memory().name, "COACH 7");
    EXPECT_EQ(bench.module.memory().channel, 0x0C) << "the text names no channel";
}

INSTANTIATE_TEST_SUITE_P(EverySpeed, RadioSetupAt,
                         ::testing::Combine(::testing::Values(0, 1, 2),
                                            ::testing::Values(1200, 2400, 4800, 9600, 19200, 38400, 57600,
                                                              115200, 250000)));

TEST(RadioSetup, ASettingAtATime) {
    Bench bench(memoryOf(1, 9600));
    RadioSettings present = bench.find()->settings;
    const auto change = [&](auto edit) {
        RadioSettings wanted = present;
        edit(wanted);
        const auto applied = bench.apply(present, wanted);
        ASSERT_TRUE(applied) << name(applied.error().code);
        EXPECT_EQ(applied->settings, wanted);
        present = wanted;
    };
    change([](RadioSettings& s) { s.address = 0xAF63; });
    change([](RadioSettings& s) { s.channel = 0x1A; });
    change([](RadioSettings& s) { s.pan = 0xFFFF; });
    change([](RadioSettings& s) { s.name.clear(); });
    change([](RadioSettings& s) { s.name = "twenty characters ok"; });
    change([](RadioSettings& s) { s.baud = 115200; });
    change([](RadioSettings& s) { s.mode = ModuleMode::ApiEscaped; });
    change([](RadioSettings& s) { s.mode = ModuleMode::Transparent; });
    change([](RadioSettings& s) { s.mode = ModuleMode::Api; });
    change([](RadioSettings&) {});
}

TEST(RadioSetup, ThunderbotsRadios) {
    Bench bench(memoryOf(0, 9600));
    const RadioSettings present = bench.find()->settings;
    const RadioSettings wanted = thunderbotsPreset(3, 1, present);
    EXPECT_EQ(wanted.address, 0x7B33);
    EXPECT_EQ(wanted.pan, 0x496D);
    const auto applied = bench.apply(present, wanted);
    ASSERT_TRUE(applied) << name(applied.error().code);
    EXPECT_EQ(bench.module.memory().baudCode, 250000U);
    EXPECT_EQ(thunderbotsPreset(std::nullopt, 0, present).address, 0x7B40);
}

TEST(RadioSetup, ASpeedThatThePortDoesNotHaveIsPassedOver) {
    Bench bench(memoryOf(1, 2400));
    bench.link.lacks = 250000;
    const auto found = bench.find();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->settings.baud, 2400U);
}

TEST(RadioSetup, AModuleIsNotSetToASpeedThatThePortDoesNotHave) {
    Bench bench(memoryOf(1, 9600));
    bench.link.lacks = 250000;
    const RadioSettings present = bench.find()->settings;
    const auto applied = bench.apply(present, thunderbotsPreset(std::nullopt, 0, present));
    ASSERT_FALSE(applied);
    EXPECT_EQ(applied.error().code, Errc::Unsupported);
    EXPECT_EQ(applied.error().subject, "250000 baud");
    EXPECT_EQ(bench.module.settings().address, 0x1234) << "nothing was said to it";
    EXPECT_TRUE(bench.find());
}

/// Ten questions a time: every frame ID there is asks first at some time.
TEST(RadioSetup, FindsAModuleInApiMode2WhateverTheFrameId) {
    Bench bench(memoryOf(2, 9600));
    for (int i = 0; i < 300; ++i) {
        const TimePoint begin = bench.scheduler.now();
        ASSERT_TRUE(bench.find()) << i;
        EXPECT_LT(bench.scheduler.now() - begin, std::chrono::seconds(1)) << "at the first speed: " << i;
    }
}

TEST(RadioSetup, WhereNothingAnswersItSaysSo) {
    Bench bench(memoryOf(1, 9600));
    bench.module.setAttached(false);
    bench.scheduler.advance(std::chrono::milliseconds(10));
    EXPECT_FALSE(bench.find());
    EXPECT_FALSE(bench.setup.busy());
}

TEST(RadioSetup, RefusesWhatCannotBeSet) {
    Bench bench(memoryOf(1, 9600));
    const RadioSettings present = bench.find()->settings;
    const auto code = [&](auto edit) {
        RadioSettings wanted = present;
        edit(wanted);
        const auto applied = bench.apply(present, wanted);
        return applied ? Errc::Io : applied.error().code;
    };
    EXPECT_EQ(code([](RadioSettings& s) { s.channel = 0x0A; }), Errc::OutOfRange);
    EXPECT_EQ(code([](RadioSettings& s) { s.channel = 0x1B; }), Errc::OutOfRange);
    EXPECT_EQ(code([](RadioSettings& s) { s.baud = 1; }), Errc::OutOfRange);
    EXPECT_EQ(code([](RadioSettings& s) { s.name = std::string(21, 'x'); }), Errc::BadArgument);
    EXPECT_EQ(code([](RadioSettings& s) { s.name = "a\rATRE"; }), Errc::BadArgument);
    EXPECT_EQ(code([](RadioSettings& s) { s.name = " first"; }), Errc::BadArgument);
    EXPECT_EQ(bench.module.memory().address, 0x1234);
}

}  // namespace
}  // namespace kickstand::coach
