#include "core/coach/sim/xbee_sim.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <utility>

namespace kickstand::coach::sim {
namespace {

using Name = std::array<char, 2>;
using xbee::AtOutcome;

constexpr Duration kGuardTime = std::chrono::seconds(1);
constexpr Duration kCommandTime = std::chrono::seconds(10);
constexpr std::array<Baud, 8> kBauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
constexpr std::uint16_t kFirmware = 0x10ED;
constexpr std::uint16_t kHardware = 0x1744;
constexpr std::size_t kLongestCommand = 40;
constexpr std::size_t kLongestName = 20;

std::vector<std::uint8_t> bytes16(std::uint32_t value) {
    std::vector<std::uint8_t> bytes(2);
    storeBe16(bytes, 0, static_cast<std::uint16_t>(value));
    return bytes;
}

std::vector<std::uint8_t> bytes32(std::uint32_t value) {
    std::vector<std::uint8_t> bytes(4);
    storeBe32(bytes, 0, value);
    return bytes;
}

std::uint64_t numberOf(ByteView bytes) {
    std::uint64_t number = 0;
    for (const std::uint8_t byte : bytes)
        number = number << 8 | byte;
    return number;
}

bool isCommand(Name name) {
    return name == Name{'W', 'R'} || name == Name{'C', 'N'} || name == Name{'A', 'C'};
}

/// As a module writes numbers: hexadecimal, without zeros in front.
std::string hexOf(std::uint64_t number) {
    std::array<char, 17> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number, 16);
    std::string hex(text.data(), end);
    std::transform(hex.begin(), hex.end(), hex.begin(),
                   [](char c) { return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c; });
    return hex;
}

}  // namespace

XbeeSim::XbeeSim(Scheduler& scheduler, RadioMedium& medium, ModuleMemory memory, std::uint64_t serial)
    : scheduler_(scheduler), medium_(medium), serial_(serial), saved_(std::move(memory)) {
    powerUp();
    medium_.add(*this);
}

XbeeSim::~XbeeSim() {
    scheduler_.cancel(guard_);
    scheduler_.cancel(commandEnd_);
    medium_.remove(*this);
}

Baud XbeeSim::baud() const {
    return now_.baudCode < kBauds.size() ? kBauds[now_.baudCode] : now_.baudCode;
}

void XbeeSim::powerUp() {
    now_ = saved_;
    wantedMode_ = now_.mode;
    wantedBaudCode_ = now_.baudCode;
    commandMode_ = false;
    pluses_ = 0;
    text_.clear();
    scheduler_.cancel(std::exchange(guard_, 0));
    scheduler_.cancel(std::exchange(commandEnd_, 0));
    lastByte_ = scheduler_.now() - kGuardTime;
    parser_.reset(now_.mode == 2 ? xbee::ApiMode::Escaped : xbee::ApiMode::Plain);
}

void XbeeSim::lineOpened(Baud baud) {
    lineBaud_ = baud;
}

void XbeeSim::setAttached(bool attached) {
    if (attached == attached_) return;
    attached_ = attached;
    if (attached) powerUp();
    if (listener_ != nullptr) listener_->attachedChanged(attached);
}

void XbeeSim::restart() {
    if (!attached_) return;
    powerUp();
    if (now_.mode != 0) frameToHost(xbee::ModemStatus{0});
}

void XbeeSim::toHost(ByteView bytes) {
    if (listener_ == nullptr || !attached_) return;
    if (lineBaud_ == baud()) {
        listener_->deviceSent(bytes);
        return;
    }
    // At another speed bits are taken for what they are not.
    const std::vector<std::uint8_t> noise(bytes.size() / 2 + 1, 0xF8);
    listener_->deviceSent(noise);
}

void XbeeSim::frameToHost(const xbee::Frame& frame) {
    const auto mode = now_.mode == 2 ? xbee::ApiMode::Escaped : xbee::ApiMode::Plain;
    toHost(xbee::wrapFrame(xbee::encodeFrame(frame).view(), mode).view());
}

void XbeeSim::hostSent(ByteView bytes) {
    if (lineBaud_ != baud()) return;
    if (now_.mode == 0) {
        for (const std::uint8_t byte : bytes)
            hear(byte);
        return;
    }
    while (now_.mode != 0) {
        const ByteView data = parser_.next(bytes);
        if (data.empty()) return;
        if (const auto frame = xbee::decodeFrame(data)) take(*frame);
    }
}

void XbeeSim::take(const xbee::Frame& frame) {
    if (const auto* packet = std::get_if<xbee::Tx16>(&frame)) transmit(*packet);
    const auto* command = std::get_if<xbee::AtCommand>(&frame);
    if (command == nullptr) return;
    const Reply reply = at(command->name, command->value);
    if (command->frameId != 0)
        frameToHost(xbee::AtResponse{command->frameId, command->name,
                                     static_cast<std::uint8_t>(reply.outcome), reply.value});
    settle();
}

void XbeeSim::transmit(const xbee::Tx16& packet) {
    ++packetsSent_;
    const std::uint8_t id = packet.frameId;
    medium_.send(*this, packet.destination, packet.payload,
                 [this, id, alive = std::weak_ptr<bool>(alive_)](xbee::TxOutcome outcome) {
                     if (alive.expired() || id == 0 || now_.mode == 0) return;
                     frameToHost(xbee::TxStatus{id, static_cast<std::uint8_t>(outcome)});
                 });
}

void XbeeSim::heard(std::uint16_t source, int rssi_dBm, bool broadcast, ByteView payload) {
    if (now_.mode == 0) {
        if (!commandMode_) toHost(payload);
        return;
    }
    frameToHost(xbee::Rx16{source, rssi_dBm, static_cast<std::uint8_t>(broadcast ? 2 : 0), payload});
}

/// A byte while transparent: for the air, unless it is the way into the command mode.
void XbeeSim::hear(std::uint8_t byte) {
    if (commandMode_) {
        hearCommand(byte);
    } else {
        plusCame(byte);
    }
    lastByte_ = scheduler_.now();
}

void XbeeSim::plusCame(std::uint8_t byte) {
    scheduler_.cancel(std::exchange(guard_, 0));
    const bool first = pluses_ == 0 && scheduler_.now() - lastByte_ >= kGuardTime;
    pluses_ = byte == '+' && (first || pluses_ > 0) ? pluses_ + 1 : 0;
    if (pluses_ != 3) return;
    guard_ = scheduler_.callAfter(kGuardTime, [this] {
        guard_ = 0;
        pluses_ = 0;
        commandMode_ = true;
        text_.clear();
        awaitCommand();
        line("");
    });
}

void XbeeSim::hearCommand(std::uint8_t byte) {
    awaitCommand();
    if (byte != '\r') {
        if (text_.size() < kLongestCommand) text_ += static_cast<char>(byte);
        return;
    }
    const std::string text = std::exchange(text_, {});
    line(text);
}

/// A command mode in which nothing is said ends by itself.
void XbeeSim::awaitCommand() {
    scheduler_.cancel(commandEnd_);
    commandEnd_ = scheduler_.callAfter(kCommandTime, [this] {
        commandEnd_ = 0;
        leaveCommandMode();
    });
}

void XbeeSim::leaveCommandMode() {
    scheduler_.cancel(std::exchange(commandEnd_, 0));
    commandMode_ = false;
    pluses_ = 0;
    settle();
}

/// One command as text; nothing at all is the greeting.
void XbeeSim::line(const std::string& text) {
    const auto say = [this](const std::string& words) {
        const std::string whole = words + "\r";
        toHost({reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()});
    };
    if (text.empty()) return say("OK");
    if (text.size() < 4 || !text.starts_with("AT")) return say("ERROR");
    const Name name{text[2], text[3]};
    const std::string argument = text.substr(4);
    std::vector<std::uint8_t> value(argument.begin(), argument.end());
    if (name != Name{'N', 'I'} && !argument.empty()) {
        std::uint32_t number = 0;
        const auto [end, error] =
            std::from_chars(argument.data(), argument.data() + argument.size(), number, 16);
        if (error != std::errc() || end != argument.data() + argument.size()) return say("ERROR");
        value = bytes32(number);
    }
    const Reply reply = at(name, value);
    if (reply.outcome != AtOutcome::Ok) return say("ERROR");
    const bool asked = value.empty() && !isCommand(name);
    if (!asked) {
        say("OK");
    } else if (name == Name{'N', 'I'}) {
        say(std::string(reply.value.begin(), reply.value.end()));
    } else {
        say(hexOf(numberOf(reply.value)));
    }
    if (name == Name{'C', 'N'}) leaveCommandMode();
}

XbeeSim::Reply XbeeSim::at(Name name, ByteView value) {
    if (name == Name{'W', 'R'}) {
        saved_ = now_;
        saved_.mode = wantedMode_;
        saved_.baudCode = wantedBaudCode_;
        return {};
    }
    if (isCommand(name)) return {};
    if (value.empty()) return ask(name);
    return {set(name, value)};
}

XbeeSim::Reply XbeeSim::ask(Name name) const {
    if (name == Name{'M', 'Y'}) return {AtOutcome::Ok, bytes16(now_.address)};
    if (name == Name{'C', 'H'}) return {AtOutcome::Ok, {now_.channel}};
    if (name == Name{'I', 'D'}) return {AtOutcome::Ok, bytes16(now_.pan)};
    if (name == Name{'A', 'P'}) return {AtOutcome::Ok, {wantedMode_}};
    if (name == Name{'B', 'D'}) return {AtOutcome::Ok, bytes32(wantedBaudCode_)};
    if (name == Name{'N', 'I'}) return {AtOutcome::Ok, {now_.name.begin(), now_.name.end()}};
    if (name == Name{'V', 'R'}) return {AtOutcome::Ok, bytes16(kFirmware)};
    if (name == Name{'H', 'V'}) return {AtOutcome::Ok, bytes16(kHardware)};
    if (name == Name{'S', 'H'}) return {AtOutcome::Ok, bytes32(static_cast<std::uint32_t>(serial_ >> 32))};
    if (name == Name{'S', 'L'}) return {AtOutcome::Ok, bytes32(static_cast<std::uint32_t>(serial_))};
    return {AtOutcome::InvalidCommand};
}

AtOutcome XbeeSim::set(Name name, ByteView value) {
    if (name == Name{'N', 'I'}) {
        if (value.size() > kLongestName) return AtOutcome::InvalidParameter;
        now_.name.assign(value.begin(), value.end());
        return AtOutcome::Ok;
    }
    const std::uint64_t number = numberOf(value);
    const auto within = [number](std::uint64_t lowest, std::uint64_t highest) {
        return number >= lowest && number <= highest;
    };
    const bool isBaud = within(0, 7) || within(1200, 250000);
    if (name == Name{'M', 'Y'} && within(0, 0xFFFF)) {
        now_.address = static_cast<std::uint16_t>(number);
    } else if (name == Name{'C', 'H'} && within(0x0B, 0x1A)) {
        now_.channel = static_cast<std::uint8_t>(number);
    } else if (name == Name{'I', 'D'} && within(0, 0xFFFF)) {
        now_.pan = static_cast<std::uint16_t>(number);
    } else if (name == Name{'A', 'P'} && within(0, 2)) {
        wantedMode_ = static_cast<std::uint8_t>(number);
    } else if (name == Name{'B', 'D'} && isBaud) {
        wantedBaudCode_ = static_cast<std::uint32_t>(number);
    } else {
        const bool known = ask(name).outcome == AtOutcome::Ok;
        return known ? AtOutcome::InvalidParameter : AtOutcome::InvalidCommand;
    }
    return AtOutcome::Ok;
}

/// Mode and speed count from now on.
void XbeeSim::settle() {
    if (commandMode_) return;
    now_.baudCode = wantedBaudCode_;
    if (now_.mode == wantedMode_) return;
    now_.mode = wantedMode_;
    lastByte_ = scheduler_.now();
    parser_.reset(now_.mode == 2 ? xbee::ApiMode::Escaped : xbee::ApiMode::Plain);
}

}  // namespace kickstand::coach::sim
