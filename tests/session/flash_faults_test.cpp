// One small upload again and again, with one thing going wrong at every message of it in turn. Whatever goes
// wrong, and whenever: the robot comes up with a whole image or says that it has no data, and the next upload
// succeeds.

#include <cstdio>
#include <map>

#include "core/thunderbots/wire/dongle.h"
#include "tests/session/flash_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;
using kickstand::testing::MessageFate;
using kickstand::testing::PassingMessage;

constexpr int kRobot = 1;

enum class Fault : std::uint8_t {
    Lost,
    Doubled,
    Delayed,
    Echoed,
    Corrupted,
    RobotReset,
    Unplugged,
    HostKilled,
    Cancelled,
    Stopped,
};
constexpr std::pair<Fault, const char*> kFaults[] = {
    {Fault::Lost, "lost"},           {Fault::Doubled, "doubled"},        {Fault::Delayed, "delayed"},
    {Fault::Echoed, "echoed"},       {Fault::Corrupted, "corrupted"},    {Fault::RobotReset, "robot reset"},
    {Fault::Unplugged, "unplugged"}, {Fault::HostKilled, "host killed"}, {Fault::Cancelled, "cancelled"},
    {Fault::Stopped, "stopped"}};

/// What becomes of the message itself. What is not about messages happens when it passes.
MessageFate fateOf(Fault fault, const PassingMessage& message) {
    MessageFate fate;
    switch (fault) {
        case Fault::Lost:
            fate.copies = 0;
            break;
        case Fault::Doubled:
            fate.copies = 2;
            break;
        case Fault::Delayed:
            fate.delay = 3s;
            break;
        case Fault::Echoed:
            fate.echo = 30ms;
            break;
        case Fault::Corrupted:
            fate.replacement.assign(message.packet.begin(), message.packet.end());
            fate.replacement.back() ^= 0x5A;
            break;
        default:
            break;
    }
    return fate;
}

/// One session in which the fault happens once.
class FaultyUpload {
  public:
    FaultyUpload(Fault fault, std::size_t index) : fault_(fault), index_(index), rig_(options()) {}

    /// Uploads with the fault, and then without one. What went wrong that must not; empty for nothing.
    std::string run(const std::vector<SharedFlashPlan>& plans) {
        if (!rig_.connect()) return "does not connect";
        begin(plans);
        waitForEnd();
        settle();
        if (std::string trouble = judgeRobot(plans); !trouble.empty()) return trouble;
        if (!recover()) return "cannot be connected to any more";
        index_ = SIZE_MAX;
        begin(plans);
        if (!waitForEnd()) return "second upload does not end";
        const FlashProgress second = progress().value_or(FlashProgress{});
        if (second.stage != FlashStage::Done)
            return std::string("second upload: ") + (second.error ? name(second.error->code) : "?");
        return holds(*plans.back()) ? "" : "second upload: another image";
    }
    std::size_t messages() const { return messages_; }
    bool happened() const { return happened_; }
    std::string ending() const { return ending_; }

  private:
    kickstand::testing::SessionRigOptions options() {
        kickstand::testing::SessionRigOptions made;
        made.sim.robots = maskOf(kRobot);
        made.sim.noise = false;
        made.sim.pace = sim::RadioPace::Ideal;
        made.keepPackets = false;
        made.decorate = [this](std::unique_ptr<UsbLink> link, Scheduler& scheduler) {
            return std::make_unique<kickstand::testing::MessageFaults>(
                std::move(link), scheduler, [this](const PassingMessage& message) { return judge(message); });
        };
        return made;
    }

    MessageFate judge(const PassingMessage& message) {
        ++messages_;
        if (happened_ || messages_ - 1 != index_) return {};
        happened_ = true;
        // From inside the link nothing is done to the session or the device.
        rig_.scheduler().post([this] { strike(); });
        return fateOf(fault_, message);
    }

    void strike() {
        switch (fault_) {
            case Fault::RobotReset:
                rig_.simulate("dead", 1, kRobot);
                rig_.scheduler().callAfter(200ms, [this] { rig_.simulate("dead", 0, kRobot); });
                break;
            case Fault::Unplugged:
                rig_.simulate("plugged", 0);
                break;
            case Fault::HostKilled:
                killed_ = true;
                break;
            case Fault::Cancelled:
                rig_.give(CancelFlash{maskOf(kRobot)});
                break;
            case Fault::Stopped:
                rig_.stop();
                stoppedAt_ = rig_.scheduler().now();
                break;
            default:
                break;
        }
    }

    void begin(const std::vector<SharedFlashPlan>& plans) {
        const auto begun = rig_.ask(StartFlash{maskOf(kRobot), plans, {}});
        // Another run of the program has never measured a robot without a bitstream: a person looks, and says
        // that its capacitor is empty.
        if (!begun && begun.error().code == Errc::ReadingsUnknown)
            rig_.ask(StartFlash{maskOf(kRobot), plans, {.capacitorUnknown = true}});
        rig_.advance(15ms);
    }
    std::optional<FlashProgress> progress() { return rig_.state().flash[kRobot]; }

    bool waitForEnd() {
        for (int i = 0; i < 3000; ++i) {
            if (killed_) {
                rig_.killHost();
                end("killed");
                return true;
            }
            const auto now = progress();
            if (now && !now->running()) {
                end(now->stage == FlashStage::Done ? "done" : name(now->error->code));
                return true;
            }
            // A person who has seen the pause goes on after a while.
            if (stoppedAt_ && rig_.scheduler().now() - *stoppedAt_ > 2s) {
                stoppedAt_.reset();
                rig_.rearm();
                rig_.ask(ResumeFlash{maskOf(kRobot)});
            }
            rig_.advance(100ms);
        }
        return false;
    }

    /// How the first upload ended.
    void end(const char* how) {
        if (ending_.empty()) ending_ = how;
    }

    /// Lets the robot do what it still does, and then boots it once more: what it comes up with is what
    /// counts.
    void settle() {
        rig_.advance(20s);
        rig_.simulate("dead", 1, kRobot);
        rig_.advance(3s);
        rig_.simulate("dead", 0, kRobot);
        rig_.advance(15s);
    }

    std::string judgeRobot(const std::vector<SharedFlashPlan>& plans) {
        const auto report = rig_.robot(kRobot);
        if (report.power != sim::RobotPower::Up) return "does not come up";
        switch (report.committed.flash()) {
            case wire::FlashContents::NoData:
                return {};
            case wire::FlashContents::Microcontroller:
                return "names an image that it has not copied";
            case wire::FlashContents::FpgaBitstream:
                break;
        }
        if (holds(*plans.back())) return {};
        // Nothing was changed yet: the bitstream that it came with.
        return flashCrc() == factory() ? "" : "names half an image";
    }

    bool recover() {
        rig_.simulate("plugged", 1);
        if (killed_) {
            // Another run of the program.
            killed_ = false;
            rig_.core().start();
            rig_.beginConnect();
        }
        rig_.rearm();
        for (int i = 0; i < 100 && !alive(); ++i)
            rig_.advance(100ms);
        rig_.rearm();
        rig_.advance(100ms);
        return alive();
    }
    bool alive() {
        const auto now = rig_.state();
        return now.link == LinkState::Running && now.robots[kRobot].live;
    }

    std::uint16_t flashCrc() {
        std::vector<std::uint8_t> flash(wire::kFlashBytes);
        rig_.sim().readFlash(kRobot, 0, flash);
        return crc16(flash);
    }
    bool holds(const FlashPlan& plan) { return flashCrc() == plan.signatures().flash; }
    static std::uint16_t factory() {
        static const std::uint16_t crc = [] {
            FakeScheduler scheduler;
            sim::ThunderbotsSim fresh(scheduler, {});
            std::vector<std::uint8_t> flash(wire::kFlashBytes);
            fresh.readFlash(kRobot, 0, flash);
            return crc16(flash);
        }();
        return crc;
    }

    const Fault fault_;
    std::size_t index_;
    kickstand::testing::SessionRig rig_;
    std::size_t messages_ = 0;
    bool happened_ = false;
    bool killed_ = false;
    std::optional<TimePoint> stoppedAt_;
    std::string ending_;
};

/// Every fault at every `stride`th message of an upload of these plans.
void tryAll(const char* what, const std::vector<SharedFlashPlan>& plans, std::size_t stride) {
    FaultyUpload whole(Fault::Lost, SIZE_MAX);
    ASSERT_EQ(whole.run(plans), "");
    int cases = 0;
    for (const auto& [fault, faultName] : kFaults) {
        std::map<std::string, int> endings;
        for (std::size_t index = static_cast<std::size_t>(fault) % stride;; index += stride) {
            FaultyUpload upload(fault, index);
            const std::string trouble = upload.run(plans);
            if (!upload.happened()) break;
            EXPECT_EQ(trouble, "") << faultName << " at message " << index;
            ++endings[upload.ending()];
            ++cases;
        }
        std::printf("%s, %s:", what, faultName);
        for (const auto& [ending, count] : endings)
            std::printf(" %d %s", count, ending.c_str());
        std::printf("\n");
    }
    std::printf("%s: %d cases\n", what, cases);
    EXPECT_GT(cases, 150);
}

/// Two pages, the second of which needs one fill.
SharedFlashPlan smallPlan(image::FlashTarget target) {
    std::vector<std::uint8_t> bytes(2 * wire::kFlashPageBytes, 0x11);
    for (std::size_t i = 0; i < 100; ++i)
        bytes[i] = static_cast<std::uint8_t>(3 * i);
    std::copy_n(bytes.begin(), wire::kFlashPageBytes, bytes.begin() + wire::kFlashPageBytes);
    bytes.back() = 0x22;
    return std::make_shared<const FlashPlan>(imageOf(std::move(bytes), target));
}

TEST(FlashFaults, AtEveryMessageOfABitstream) {
    tryAll("bitstream", {smallPlan(kFpga)}, 1);
}

TEST(FlashFaults, AtEveryFifthMessageOfAMicrocontrollerAndABitstream) {
    tryAll("microcontroller and bitstream", {smallPlan(kMicrocontroller), smallPlan(kFpga)}, 5);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
