#include "tests/unit/usbip/usbip_rig.h"

#include <gtest/gtest.h>

namespace kickstand::testing {

using namespace std::chrono_literals;
using usbip::Command;
using usbip::Parse;

RawClient::RawClient(Scheduler& scheduler, std::unique_ptr<ByteStream> stream)
    : scheduler_(scheduler), stream_(std::move(stream)) {}

void RawClient::read() {
    stream_->start({.received = [this](ByteView bytes) { received(bytes); },
                    .closed = [this](const Error&) { closed_ = true; }});
}

void RawClient::list() {
    stage_ = Stage::List;
    send(usbip::encodeRequest({}));
}

void RawClient::import(const std::string& busId) {
    stage_ = Stage::Import;
    send(usbip::encodeRequest({usbip::Request::Kind::Import, busId}));
}

std::uint32_t RawClient::submit(Command command) {
    command.sequence = ++lastSequence_;
    command.device = device_.id();
    if (isInEndpoint(command.endpoint)) ins_.insert(command.sequence);
    send(usbip::encodeCommand(command));
    return command.sequence;
}

std::uint32_t RawClient::in(std::uint8_t endpoint, std::uint32_t length) {
    Command command;
    command.endpoint = endpoint;
    command.length = length;
    return submit(command);
}

std::uint32_t RawClient::out(std::uint8_t endpoint, std::vector<std::uint8_t> bytes, std::uint32_t flags) {
    Command command;
    command.endpoint = endpoint;
    command.flags = flags;
    command.length = static_cast<std::uint32_t>(bytes.size());
    command.data = bytes;
    return submit(command);
}

std::uint32_t RawClient::controlIn(const UsbSetup& setup, std::uint32_t length) {
    Command command;
    command.endpoint = 0x80;
    command.setup = setup;
    command.length = length;
    return submit(command);
}

std::uint32_t RawClient::controlOut(const UsbSetup& setup, std::vector<std::uint8_t> bytes) {
    Command command;
    command.setup = setup;
    command.length = static_cast<std::uint32_t>(bytes.size());
    command.data = bytes;
    return submit(command);
}

std::uint32_t RawClient::unlink(std::uint32_t sequence) {
    Command command;
    command.kind = Command::Kind::Unlink;
    command.unlink = sequence;
    return submit(command);
}

const RawClient::Answer* RawClient::answer(std::uint32_t sequence) const {
    for (const Answer& one : answers_) {
        if (one.reply.sequence == sequence) return &one;
    }
    return nullptr;
}

void RawClient::received(ByteView bytes) {
    unread_.insert(unread_.end(), bytes.begin(), bytes.end());
    std::size_t taken = 0;
    while (taken < unread_.size()) {
        const Parse parse = take(ByteView(unread_).subspan(taken));
        if (parse.status != Parse::Status::Complete) {
            sane_ = sane_ && parse.status == Parse::Status::MoreNeeded;
            break;
        }
        taken += parse.bytes;
    }
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(taken));
}

Parse RawClient::take(ByteView bytes) {
    if (stage_ == Stage::Transfers) return takeReply(bytes);
    usbip::OpStatus status{};
    const Parse parse = stage_ == Stage::List ? usbip::parseDeviceList(bytes, status, devices_)
                                              : usbip::parseImportReply(bytes, status, device_);
    if (parse.status != Parse::Status::Complete) return parse;
    status_ = status;
    stage_ = Stage::Transfers;
    return parse;
}

Parse RawClient::takeReply(ByteView bytes) {
    Answer answer;
    Parse parse = usbip::parseReply(bytes, answer.reply);
    if (parse.status != Parse::Status::Complete) return parse;
    if (answer.reply.kind == Command::Kind::Submit && ins_.contains(answer.reply.sequence)) {
        const std::size_t size = answer.reply.actual;
        if (bytes.size() < parse.bytes + size) return {Parse::Status::MoreNeeded, parse.bytes + size, ""};
        const ByteView data = bytes.subspan(parse.bytes, size);
        answer.data.assign(data.begin(), data.end());
        parse.bytes += size;
    }
    answer.time = scheduler_.now();
    answers_.push_back(std::move(answer));
    return parse;
}

UsbipRig::UsbipRig(const std::vector<UsbipExport>& exports, const UsbipLimits& limits, std::uint32_t seed)
    : limits_(limits),
      seed_(seed),
      hall_{.exports = UsbipExports::make(exports).value(),
            .log = [this](const std::string& line) { log_.push_back(line); }} {}

RawClient& UsbipRig::connect(bool reads) {
    auto [server, client] = makeMemoryStreams(scheduler_, {.seed = seed_++, .largestPiece = 100});
    const auto place = connections_.emplace(connections_.end());
    *place = std::make_unique<UsbipConnection>(scheduler_, std::move(server), hall_, limits_,
                                               [this, place] { connections_.erase(place); });
    RawClient& made = clients_.emplace_back(scheduler_, std::move(client));
    if (reads) made.read();
    return made;
}

RawClient& UsbipRig::connectAndImport(const std::string& busId) {
    RawClient& client = connect();
    client.import(busId);
    scheduler_.runPending();
    EXPECT_EQ(client.status(), usbip::OpStatus::Ok);
    return client;
}

RawClient::Answer UsbipRig::await(RawClient& client, std::uint32_t sequence) {
    const bool came = scheduler_.runUntil([&] { return client.answer(sequence) != nullptr; }, 10s);
    EXPECT_TRUE(came) << "no answer to command " << sequence;
    return came ? *client.answer(sequence) : RawClient::Answer{};
}

}  // namespace kickstand::testing
