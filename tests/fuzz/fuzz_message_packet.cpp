#include "core/thunderbots/wire/message_packet.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    for (const Direction direction : {Direction::Out, Direction::In}) {
        const auto message = decodeMessagePacket(input, direction);
        if (!message) continue;
        fuzz::require(directionOf(message->pipe) == direction, "a pipe has one direction");
        const auto packet = encodeMessagePacket(message->robot, message->pipe, message->payload);
        fuzz::require(packet && fuzz::sameBytes(packet->view(), input), "what was read is written the same");
    }
    return 0;
}
