// Codecs run for every packet on the engine's thread: none of them may allocate. This program counts.
#include <atomic>
#include <cstdlib>
#include <new>

#include "core/framing/crc16.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/faults.h"
#include "core/thunderbots/wire/fields.h"
#include "core/thunderbots/wire/firmware.h"
#include "core/thunderbots/wire/indicator.h"
#include "core/thunderbots/wire/kick_timing.h"
#include "core/thunderbots/wire/micropacket.h"
#include "core/thunderbots/wire/test_mode.h"
#include "tests/unit/wire/wire_testing.h"

namespace {

std::atomic<long> allocations{0};

void* allocate(std::size_t size) {
    ++allocations;
    void* const memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) std::abort();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocate(size);
}
void* operator new[](std::size_t size) {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

/// Runs every decoder on `bytes`, and every encoder on what was accepted. The count keeps the work from being
/// left out.
int decodeEverything(ByteView bytes) {
    int accepted = 0;
    const auto run = [&accepted](const auto& decoded, const auto& encode) {
        if (!decoded) return;
        const auto encoded = encode(*decoded);
        accepted += encoded.begin() == encoded.end() ? 1 : 2;
    };
    const auto orEmpty = [](const auto& encoded) {
        return encoded.value_or(typename std::decay_t<decltype(encoded)>::value_type{});
    };
    run(decodeDrive(bytes), [&](const auto& block) { return orEmpty(encodeDrive(block)); });
    run(decodeFeedback(bytes), [&](const auto& block) { return orEmpty(encodeFeedback(block)); });
    run(decodeKick(bytes), [&](const auto& times) {
        const auto encoding = encodePulses(personTermsOf(times));
        return orEmpty(encodeKick(encoding ? encoding->times : times));
    });
    run(decodeTestMode(bytes), [&](const auto& mode) { return orEmpty(encodeTestMode(mode)); });
    run(decodeIndicator(bytes), [&](const auto& message) { return orEmpty(encodeIndicator(message)); });
    run(decodeFirmwareRequest(bytes),
        [&](const auto& message) { return orEmpty(encodeFirmwareRequest(message)); });
    run(decodeFirmwareResponse(bytes),
        [&](const auto& message) { return orEmpty(encodeFirmwareResponse(message)); });
    run(decodeParameters(bytes), [](const auto& parameters) { return encodeParameters(parameters); });
    run(decodeStatus(bytes), [](const auto& status) { return encodeStatus(status); });
    run(decodeChannels(bytes), [&](const auto& channels) { return orEmpty(encodeChannels(channels)); });
    run(decodeRadioVersions(bytes), [](const auto& versions) { return encodeRadioVersions(versions); });
    for (const Direction direction : {Direction::Out, Direction::In}) {
        run(decodeMessagePacket(bytes, direction), [&](const auto& message) {
            return orEmpty(encodeMessagePacket(message.robot, message.pipe, message.payload));
        });
        MicropacketReader reader(bytes, direction);
        StatePacketBuilder builder;
        while (const auto next = reader.next()) {
            if (*next && direction == Direction::Out) {
                const auto block = decodeDrive((*next)->payload);
                if (block && builder.add((*next)->robot, *block)) ++accepted;
            }
        }
    }
    for (const MessageSpec& message : messages())
        accepted += message.mayBeRead(bytes).has_value() ? 1 : 0;
    accepted += findMessageFor("thunderbots.firmware-request", bytes) != nullptr ? 1 : 0;
    for (const std::uint8_t byte : bytes)
        accepted += dongleFault(byte).known && robotFault(byte).known ? 1 : 0;
    return accepted + (crc16(bytes) & 1);
}

TEST(Allocation, TheCounterCounts) {
    const long before = allocations;
    {
        const std::vector<int> some(10);
        EXPECT_EQ(some.size(), 10U);
    }
    EXPECT_GT(allocations, before);
}

TEST(Allocation, NoCodecAllocates) {
    std::mt19937 random(13);
    int accepted = 0;
    for (int i = 0; i < 20'000; ++i) {
        Bytes bytes = randomBytes(random, static_cast<std::size_t>(between(random, 0, 66)));
        if (!bytes.empty() && i % 2 == 0) bytes[0] &= 0x0F;
        const long before = allocations;
        accepted += decodeEverything(bytes);
        const long during = allocations - before;
        ASSERT_EQ(during, 0) << toHex(bytes);
    }
    EXPECT_GT(accepted, 20'000) << "the inputs must reach the encoders too";
}

TEST(Allocation, NoStatePacketAllocates) {
    std::mt19937 random(14);
    StatePacketBuilder builder;
    for (std::uint8_t robot = 0; robot < kMaxMicropackets; ++robot) {
        ASSERT_TRUE(builder.add(robot, randomDrive(random)).has_value());
    }
    const long before = allocations;
    const int accepted = decodeEverything(builder.packet());
    EXPECT_EQ(allocations, before);
    EXPECT_GE(accepted, 5);
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
