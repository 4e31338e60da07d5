// How long uploads take, and how many packets, against what is possible at all (flash_bound.h) and against a
// plain uploader that erases, fills 61 bytes at a time, programs, and checks blocks of 16 KiB, one robot
// after the other. In simulated time, on a link of one packet a millisecond and an ideal radio: the figures
// are the same in every run. From the command until the last block is verified; reboots are not in it.
//
//     bench_flash

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "core/framing/crc16.h"
#include "tests/bench/thunderbots/flash_bound.h"
#include "tests/support/session/request_rig.h"
#include "tests/support/session/session_rig.h"

namespace {

using namespace kickstand;
using namespace kickstand::thunderbots;
using namespace std::chrono_literals;
using kickstand::testing::RequestRig;
using kickstand::testing::SessionRig;
using Bytes = std::vector<std::uint8_t>;

struct Figures {
    double time_ms = 0;
    std::size_t packets = 0;
};

[[noreturn]] void giveUp(const char* what) {
    std::fprintf(stderr, "bench_flash: %s\n", what);
    std::exit(1);
}

double ms(Duration span) {
    return 1000 * seconds(span);
}

sim::ThunderbotsSimOptions simOptions(int robots) {
    sim::ThunderbotsSimOptions options;
    options.robots = static_cast<RobotMask>((1U << robots) - 1);
    options.pace = sim::RadioPace::Ideal;
    options.noise = false;
    return options;
}

// ---- Images ----

Bytes denseImage(std::size_t size) {
    std::mt19937 random(1);
    Bytes bytes(size);
    std::ranges::generate(bytes, [&random] { return static_cast<std::uint8_t>(random()); });
    return bytes;
}

/// Like a bitstream of a design that fills a part of its chip: frames that are empty, like the one before but
/// for some bits, or full, and some that are blank.
Bytes sparseImage(std::size_t size) {
    constexpr std::size_t kFrame = 64;
    std::mt19937 random(2);
    Bytes bytes(size, 0);
    for (std::size_t at = 0; at + kFrame <= size; at += kFrame) {
        const auto kind = random() % 10;
        for (std::size_t i = at; i < at + kFrame; ++i) {
            if (kind < 3 && at >= kFrame) bytes[i] = bytes[i - kFrame];
            if (kind == 3) bytes[i] = static_cast<std::uint8_t>(random());
            if (at / 4096 % 5 == 4) bytes[i] = 0xFF;
        }
        if (kind == 4 && at / 4096 % 5 != 4) bytes[at + random() % kFrame] ^= 0x10;
    }
    return bytes;
}

/// Like firmware: three quarters of it code, a gap, and tables at the end of what is copied.
Bytes microcontrollerImage() {
    Bytes bytes = denseImage(image::kMicrocontrollerCopiedBytes);
    std::fill(bytes.begin() + 0x18000, bytes.begin() + 0x1C000, std::uint8_t{0xFF});
    return bytes;
}

// ---- Uploaders ----

Figures upload(const Bytes& bytes, image::FlashTarget target, int robots) {
    kickstand::testing::SessionRigOptions options;
    options.sim = simOptions(robots);
    SessionRig rig(options);
    if (!rig.connect()) giveUp("the simulation does not start");
    rig.forgetPackets();
    image::FlashImage image;
    image.bytes = bytes;
    image.target = target;
    const TimePoint begun = rig.scheduler().now();
    const auto plan = std::make_shared<const FlashPlan>(std::move(image));
    if (!rig.ask(StartFlash{options.sim.robots, {plan}, {}})) giveUp("an upload is refused");
    TimePoint verified{};
    for (int robot = 0; robot < robots; ++robot) {
        const auto progress = [&] {
            return rig.state().flash[static_cast<std::size_t>(robot)].value_or(FlashProgress{});
        };
        while (progress().stage < FlashStage::Rebooting)
            rig.advance(100ms);
        if (progress().stage > FlashStage::Done) giveUp("an upload fails");
        for (const FlashLogLine& line : *progress().log) {
            if (line.note == FlashNote::Verified) verified = std::max(verified, line.time);
        }
    }
    Figures figures{ms(verified - begun), 0};
    for (const auto& packet : rig.packets()) {
        if (packet.endpoint == wire::address(wire::Endpoint::MessageOut) && packet.time <= verified)
            ++figures.packets;
    }
    return figures;
}

wire::FirmwareResponse mustAnswer(RequestRig& rig, int robot, const wire::FirmwareRequest& request) {
    const auto answer = rig.ask(robot, request);
    if (!answer) giveUp("a request fails");
    return *answer;
}

void uploadPlainly(RequestRig& rig, int robot, const Bytes& bytes) {
    constexpr std::size_t kBlock = 16384;
    mustAnswer(rig, robot, wire::EraseChipRequest{});
    for (std::size_t at = 0; at < bytes.size(); at += wire::kFlashPageBytes) {
        const ByteView page = ByteView(bytes).subspan(at, std::min(wire::kFlashPageBytes, bytes.size() - at));
        std::vector<wire::FillPageRequest> fills;
        for (std::size_t offset = 0; offset < page.size(); offset += wire::kMaxFillBytes) {
            wire::FillPageRequest fill;
            fill.offset = static_cast<std::uint8_t>(offset);
            fill.data.append(page.subspan(offset, std::min(wire::kMaxFillBytes, page.size() - offset)));
            fills.push_back(fill);
        }
        const auto number = static_cast<std::uint16_t>(at / wire::kFlashPageBytes);
        if (!rig.program(robot, fills, {number, crc16(page)})) giveUp("a page is refused");
    }
    for (std::size_t at = 0; at < bytes.size(); at += kBlock) {
        const std::size_t size = std::min(kBlock, bytes.size() - at);
        const auto answer = mustAnswer(
            rig, robot,
            wire::BlockCrcRequest{static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(size)});
        const auto* block = std::get_if<wire::BlockCrcResponse>(&answer);
        if (!block || block->crc != crc16(ByteView(bytes).subspan(at, size))) giveUp("a block is wrong");
    }
}

Figures uploadPlainly(const Bytes& bytes, int robots) {
    RequestRig rig(simOptions(robots));
    if (!rig.connect()) giveUp("the simulation does not start");
    const TimePoint begun = rig.scheduler.now();
    for (int robot = 0; robot < robots; ++robot)
        uploadPlainly(rig, robot, bytes);
    return {ms(rig.scheduler.now() - begun), rig.messagesOut()};
}

void print(const char* name, int robots, const Bytes& bytes, image::FlashTarget target, const char* end) {
    const bench::FlashBound bound = bench::flashBound(bytes);
    const double bound_ms = robots == 1 ? bound.one_ms() : bound.several_ms(robots);
    const double erased_ms = robots == 1 ? bound.one_ms() : bound.severalErased_ms(robots);
    const Figures ours = upload(bytes, target, robots);
    const Figures plain = uploadPlainly(bytes, robots);
    std::printf(
        "    {\"image\": \"%s\", \"robots\": %d, \"bound_ms\": %.1f, \"bound_after_erasure_ms\": %.1f,\n"
        "     \"upload\": {\"ms\": %.1f, \"packets\": %zu, \"percent_of_bound\": %.1f, "
        "\"percent_of_bound_after_erasure\": %.1f},\n"
        "     \"plain\": {\"ms\": %.1f, \"packets\": %zu, \"percent_of_bound\": %.1f}, "
        "\"plain_takes_times\": %.2f}%s\n",
        name, robots, bound_ms, erased_ms, ours.time_ms, ours.packets, 100 * bound_ms / ours.time_ms,
        100 * erased_ms / ours.time_ms, plain.time_ms, plain.packets, 100 * bound_ms / plain.time_ms,
        plain.time_ms / ours.time_ms, end);
}

}  // namespace

int main() {
    constexpr std::size_t kBitstream = 348160;
    const Bytes dense = denseImage(kBitstream);
    const Bytes sparse = sparseImage(kBitstream);
    const Bytes firmware = microcontrollerImage();
    std::printf("{\"uploads\": [\n");
    for (const int robots : {1, 8}) {
        print("dense random 340 KB", robots, dense, image::FlashTarget::Fpga, ",");
        print("sparse bitstream 340 KB", robots, sparse, image::FlashTarget::Fpga, ",");
        print("microcontroller 128 KiB", robots, firmware, image::FlashTarget::Microcontroller,
              robots == 8 ? "" : ",");
    }
    std::printf("]}\n");
    return 0;
}
