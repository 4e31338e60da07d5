#include "tests/unit/sim/sim_host.h"

#include <algorithm>

#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots::sim::test {
namespace {

constexpr Duration kKeepAlive = 300ms;
constexpr Duration kReadEvery = 5ms;

}  // namespace

ThunderbotsSimOptions quietOptions(std::uint16_t robots) {
    ThunderbotsSimOptions options;
    options.robots = robots;
    options.pace = RadioPace::Ideal;
    options.noise = false;
    return options;
}

wire::DriveBlock running(std::int16_t speed) {
    wire::DriveBlock block;
    block.run = true;
    block.wheels.fill(speed);
    return block;
}

SimHost::SimHost(const ThunderbotsSimOptions& options) : sim(scheduler, options), device(sim.device()) {
    device.setListener(this);
}

SimHost::~SimHost() {
    device.setListener(nullptr);
}

UsbHandshake SimHost::setConfiguration(std::uint16_t value) {
    std::vector<std::uint8_t> in;
    return device.control({.requestType = 0, .request = 9, .value = value}, {}, in);
}

UsbHandshake SimHost::vendor(std::uint8_t requestType, wire::VendorRequest request, std::uint16_t value) {
    std::vector<std::uint8_t> in;
    return device.control(
        {.requestType = requestType, .request = static_cast<std::uint8_t>(request), .value = value}, {}, in);
}

void SimHost::configure() {
    setConfiguration(0);
    setConfiguration(1);
    vendor(wire::kVendorOut, wire::VendorRequest::EnableRadios);
    vendor(wire::kVendorOut, wire::VendorRequest::ResendStatus);
}

bool SimHost::start(std::uint16_t robots) {
    configure();
    return runUntil([&] { return sim.deviceReport().status.aliveRobots == robots; }, 5s);
}

void SimHost::run(Duration span) {
    runUntil([] { return false; }, span);
}

bool SimHost::runUntil(const std::function<bool()>& done, Duration limit) {
    const TimePoint end = scheduler.now() + limit;
    while (!done()) {
        if (scheduler.now() >= end) return false;
        if (scheduler.now() - lastPacket_ >= kKeepAlive && device.attached()) keepAlive();
        stayQuiet(std::min(kReadEvery, end - scheduler.now()));
    }
    return true;
}

void SimHost::stayQuiet(Duration span) {
    const TimePoint end = scheduler.now() + span;
    do {
        scheduler.advance(std::min(kReadEvery, end - scheduler.now()));
        if (device.attached()) drain();
    } while (scheduler.now() < end);
}

std::optional<std::vector<std::uint8_t>> SimHost::read(wire::Endpoint endpoint) {
    std::array<std::uint8_t, wire::kPacketBytes> buffer{};
    std::size_t actual = 0;
    if (device.in(address(endpoint), buffer, actual) != UsbHandshake::Ack) return std::nullopt;
    return std::vector<std::uint8_t>(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(actual));
}

void SimHost::drain() {
    while (const auto packet = read(wire::Endpoint::Status))
        statuses.push_back(wire::decodeStatus(*packet).value());
    while (const auto packet = read(wire::Endpoint::ErrorQueue))
        errors.insert(errors.end(), packet->begin(), packet->end());
    while (const auto packet = read(wire::Endpoint::DebugText))
        text.append(packet->begin(), packet->end());
    while (const auto packet = read(wire::Endpoint::StateIn)) {
        wire::MicropacketReader reader(*packet, wire::Direction::In);
        statePackets.push_back(0);
        while (const auto part = reader.next()) {
            ++statePackets.back();
            feedback[part->value().robot].push_back(wire::decodeFeedback(part->value().payload).value());
        }
    }
    while (const auto packet = read(wire::Endpoint::MessageIn)) {
        const wire::MessageView message = wire::decodeMessagePacket(*packet, wire::Direction::In).value();
        messages.push_back({message.robot, message.pipe, {message.payload.begin(), message.payload.end()}});
    }
}

UsbHandshake SimHost::out(wire::Endpoint endpoint, ByteView packet) {
    if (endpoint == wire::Endpoint::StateOut) lastPacket_ = scheduler.now();
    return device.out(address(endpoint), packet);
}

UsbHandshake SimHost::drive(std::uint8_t robot, const wire::DriveBlock& block) {
    wire::StatePacketBuilder builder;
    builder.addDrive(robot, wire::encodeDrive(block).value());
    return out(wire::Endpoint::StateOut, builder.packet());
}

UsbHandshake SimHost::message(std::uint8_t robot, wire::Pipe pipe, ByteView payload) {
    const auto packet = wire::encodeMessagePacket(robot, pipe, payload).value();
    return out(wire::Endpoint::MessageOut, packet.view());
}

UsbHandshake SimHost::kick(std::uint8_t robot, const wire::KickTimes& times) {
    return message(robot, wire::Pipe::Kick, wire::encodeKick(times).value());
}

UsbHandshake SimHost::firmware(std::uint8_t robot, const wire::FirmwareRequest& request) {
    return message(robot, wire::Pipe::FirmwareRequest, wire::encodeFirmwareRequest(request).value().view());
}

std::optional<wire::FirmwareResponse> SimHost::ask(std::uint8_t robot, const wire::FirmwareRequest& request,
                                                   Duration limit) {
    const std::size_t before = messages.size();
    firmware(robot, request);
    const auto isResponse = [robot](const InMessage& message) {
        return message.robot == robot && message.pipe == wire::Pipe::FirmwareResponse;
    };
    auto found = messages.end();
    runUntil(
        [&] {
            found = std::find_if(messages.begin() + static_cast<std::ptrdiff_t>(before), messages.end(),
                                 isResponse);
            return found != messages.end();
        },
        limit);
    if (found == messages.end()) return std::nullopt;
    return wire::decodeFirmwareResponse(found->payload).value();
}

bool SimHost::perform(std::string_view action, int unit, double value) {
    return sim.control().perform(action, unit, value).has_value();
}

std::size_t SimHost::count(wire::Pipe pipe) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(messages, [pipe](const InMessage& message) { return message.pipe == pipe; }));
}

}  // namespace kickstand::thunderbots::sim::test
