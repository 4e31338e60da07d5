#include "tests/ui/wire_log.h"

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/pipes.h"

namespace kickstand::test {

using namespace thunderbots;

void WireLog::observe(const UsbTapRecord& record) {
    if (record.kind != UsbTapRecord::Kind::Completed || record.status != UsbStatus::Completed) return;
    ++packets_;
    if (record.endpoint == wire::address(wire::Endpoint::StateOut)) readState(record.data);
    if (record.endpoint == wire::address(wire::Endpoint::MessageOut)) readMessage(record.data);
}

void WireLog::readState(ByteView packet) {
    const std::lock_guard lock(mutex_);
    // Taken apart by hand: the test is no judge if it reads with what it judges.
    while (packet.size() >= 2) {
        const std::size_t length = packet[0];
        if (length < 2 || length > packet.size()) return;
        const int robot = packet[1] >> 4;
        const bool drive = (packet[1] & 0x0F) == 0;
        const auto block = wire::decodeDrive(packet.subspan(2, length - 2));
        if (drive && block) blocks_[static_cast<std::size_t>(robot)].push_back(*block);
        packet = packet.subspan(length);
    }
}

void WireLog::readMessage(ByteView packet) {
    const std::lock_guard lock(mutex_);
    if (packet.empty()) return;
    const int robot = packet[0] >> 4;
    const int pipe = packet[0] & 0x0F;
    if (pipe == static_cast<int>(wire::Pipe::Kick)) {
        kicks_.push_back(robot);
        kickBytes_.emplace_back(packet.begin() + 1, packet.end());
    }
    if (pipe == static_cast<int>(wire::Pipe::FirmwareRequest))
        firmware_[static_cast<std::size_t>(robot)].emplace_back(packet.begin() + 1, packet.end());
    if (pipe == static_cast<int>(wire::Pipe::TestMode) && packet.size() == 3)
        testModes_.push_back({robot, packet[1], packet[2]});
}

void WireLog::clear() {
    const std::lock_guard lock(mutex_);
    for (auto& blocks : blocks_)
        blocks.clear();
    kicks_.clear();
    kickBytes_.clear();
    testModes_.clear();
    for (auto& messages : firmware_)
        messages.clear();
}

std::vector<wire::DriveBlock> WireLog::blocks(int robot) const {
    const std::lock_guard lock(mutex_);
    return blocks_[static_cast<std::size_t>(robot)];
}

std::optional<wire::DriveBlock> WireLog::last(int robot) const {
    const std::lock_guard lock(mutex_);
    const auto& blocks = blocks_[static_cast<std::size_t>(robot)];
    if (blocks.empty()) return std::nullopt;
    return blocks.back();
}

std::vector<int> WireLog::kicks() const {
    const std::lock_guard lock(mutex_);
    return kicks_;
}

std::vector<std::vector<std::uint8_t>> WireLog::firmware(int robot) const {
    const std::lock_guard lock(mutex_);
    return firmware_[static_cast<std::size_t>(robot)];
}

std::vector<std::array<int, 3>> WireLog::testModes() const {
    const std::lock_guard lock(mutex_);
    return testModes_;
}

std::vector<std::vector<std::uint8_t>> WireLog::kickBytes() const {
    const std::lock_guard lock(mutex_);
    return kickBytes_;
}

}  // namespace kickstand::test
