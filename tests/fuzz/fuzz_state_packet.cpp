#include "core/thunderbots/wire/micropacket.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

namespace {

void readWhole(ByteView packet, Direction direction) {
    MicropacketReader reader(packet, direction);
    std::size_t read = 0;
    std::size_t count = 0;
    bool failed = false;
    while (const auto next = reader.next()) {
        fuzz::require(!failed, "an error ends the packet");
        if (!*next) {
            failed = true;
            continue;
        }
        read += kMicropacketHeaderBytes + (*next)->payload.size();
        ++count;
        fuzz::require((*next)->robot < kRobotCount, "robots are numbered 0-15");
        if (direction == Direction::Out) {
            static_cast<void>(decodeDrive((*next)->payload));
        } else {
            static_cast<void>(decodeFeedback((*next)->payload));
        }
    }
    fuzz::require(read + reader.droppedBytes() == packet.size(), "every byte is read or counted as dropped");
    fuzz::require(failed == (reader.droppedBytes() > 0), "bytes are dropped only after an error");
    fuzz::require(count <= kMaxMicropackets, "a packet holds five at most");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    readWhole({data, size}, Direction::Out);
    readWhole({data, size}, Direction::In);
    return 0;
}
