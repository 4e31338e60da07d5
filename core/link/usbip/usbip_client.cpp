#include "core/link/usbip/usbip_client.h"

#include <utility>

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using usbip::Command;
using usbip::OpStatus;
using usbip::Parse;
using usbip::Reply;
using usbip::TransferStatus;

// Silence is counted in ticks rather than measured, so that a pause of this program is not taken for one of
// the server.
constexpr Duration kTick = 500ms;
constexpr int kTicksBetweenProbes = 2;
constexpr int kTicksToLoss = 6;
/// Commands that a server may leave unread: far more than a bench ever has under way.
constexpr std::size_t kMaxUnsentBytes = 4UL * 1024 * 1024;

constexpr const char* kSubject = "usbip server";

constexpr Parse malformed(const char* why) {
    return {Parse::Status::Malformed, 0, why};
}

Error refusal(OpStatus status) {
    Error error;
    error.subject = kSubject;
    error.got = static_cast<std::int64_t>(status);
    switch (status) {
        case OpStatus::Busy:
            error.code = Errc::ClaimedElsewhere;
            error.detail = "the server has given it to another client";
            break;
        case OpStatus::NoDevice:
        case OpStatus::NotAvailable:
            error.code = Errc::NoDevice;
            error.detail = "the server does not export this device";
            break;
        default:
            error.code = Errc::Io;
            error.detail = "the server refused";
            break;
    }
    return error;
}

UsbStatus toUsb(TransferStatus status, bool unlinked) {
    switch (status) {
        case TransferStatus::Ok:
        case TransferStatus::ShortRead:
            return UsbStatus::Completed;
        case TransferStatus::Stall:
            return UsbStatus::Stalled;
        case TransferStatus::Overflow:
            return UsbStatus::Overflow;
        case TransferStatus::NoDevice:
        case TransferStatus::Shutdown:
            return UsbStatus::NoDevice;
        case TransferStatus::NoEntry:
        case TransferStatus::Reset:
            return unlinked ? UsbStatus::Cancelled : UsbStatus::Failed;
        default:
            return UsbStatus::Failed;
    }
}

}  // namespace

UsbipClient::UsbipClient(Scheduler& scheduler, std::unique_ptr<ByteStream> stream)
    : scheduler_(scheduler), stream_(std::move(stream)) {
    stream_->start({.received = [this](ByteView bytes) { received(bytes); },
                    .closed =
                        [this](const Error& error) {
                            lose({.code = error.code, .subject = kSubject, .detail = error.detail});
                        }});
    ticker_ = scheduler_.callAfter(kTick, [this] { tick(); });
}

UsbipClient::~UsbipClient() {
    scheduler_.cancel(ticker_);
}

// ---- Asking ----

void UsbipClient::list(Listed done) {
    listed_ = std::move(done);
    ask(Phase::Listing, {usbip::Request::Kind::List, {}});
}

void UsbipClient::import(const std::string& busId, Imported done, std::function<void(const Error&)> lost) {
    imported_ = std::move(done);
    lost_ = std::move(lost);
    ask(Phase::Importing, {usbip::Request::Kind::Import, busId});
}

void UsbipClient::ask(Phase phase, const usbip::Request& request) {
    phase_ = phase;
    stream_->send(usbip::encodeRequest(request));
}

// ---- What the server says ----

void UsbipClient::received(ByteView bytes) {
    if (phase_ == Phase::Over) return;
    quietTicks_ = 0;
    unread_.insert(unread_.end(), bytes.begin(), bytes.end());
    const std::weak_ptr alive(alive_);
    std::size_t taken = 0;
    while (phase_ != Phase::Over) {
        const Parse parse = take(ByteView(unread_).subspan(taken));
        if (alive.expired()) return;
        if (parse.status == Parse::Status::Malformed)
            return lose({.code = Errc::Malformed, .subject = kSubject, .detail = parse.why});
        if (parse.status == Parse::Status::MoreNeeded) break;
        taken += parse.bytes;
    }
    // A message is bounded by its parser, so what is kept here is too.
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(taken));
}

Parse UsbipClient::take(ByteView bytes) {
    switch (phase_) {
        case Phase::Listing:
            return takeList(bytes);
        case Phase::Importing:
            return takeImport(bytes);
        case Phase::Transferring:
            return takeReply(bytes);
        default:
            return bytes.empty() ? Parse{Parse::Status::MoreNeeded, 1, ""}
                                 : malformed("an answer before any question");
    }
}

Parse UsbipClient::takeList(ByteView bytes) {
    OpStatus status = OpStatus::Error;
    std::vector<usbip::Device> devices;
    const Parse parse = usbip::parseDeviceList(bytes, status, devices);
    if (parse.status != Parse::Status::Complete) return parse;
    phase_ = Phase::Over;
    const auto done = std::exchange(listed_, nullptr);
    if (status == OpStatus::Ok)
        done(std::move(devices));
    else
        done(fail(refusal(status)));
    return parse;
}

Parse UsbipClient::takeImport(ByteView bytes) {
    OpStatus status = OpStatus::Error;
    usbip::Device device;
    const Parse parse = usbip::parseImportReply(bytes, status, device);
    if (parse.status != Parse::Status::Complete) return parse;
    const auto done = std::exchange(imported_, nullptr);
    if (status == OpStatus::Ok) {
        phase_ = Phase::Transferring;
        device_ = device.id();
        done(std::move(device));
    } else {
        phase_ = Phase::Over;
        done(fail(refusal(status)));
    }
    return parse;
}

Parse UsbipClient::takeReply(ByteView bytes) {
    Reply reply;
    Parse parse = usbip::parseReply(bytes, reply);
    if (parse.status != Parse::Status::Complete) return parse;
    if (reply.kind == Command::Kind::Unlink) {
        const Parse unlinked = takeUnlinkReply(reply);
        return unlinked.status == Parse::Status::Complete ? parse : unlinked;
    }
    const auto found = transfers_.find(reply.sequence);
    if (found == transfers_.end()) return malformed("an answer to what was not asked");
    const Transfer& transfer = found->second;
    if (reply.actual > transfer.size) return malformed("more bytes than were asked for");
    const std::size_t follow = transfer.isIn ? reply.actual : 0;
    parse.bytes = usbip::kReplySize + follow;
    if (bytes.size() < parse.bytes) return {Parse::Status::MoreNeeded, parse.bytes, ""};
    const ByteView data = bytes.subspan(usbip::kReplySize, follow);
    finish(reply.sequence, toUsb(reply.status, transfer.unlinked), data, reply.actual);
    return parse;
}

Parse UsbipClient::takeUnlinkReply(const Reply& reply) {
    const auto unlink = unlinks_.extract(reply.sequence);
    if (unlink.empty()) return malformed("an answer to what was not asked");
    if (reply.sequence == probe_) roundTrip_ = scheduler_.now() - probedAt_;
    // A transfer that ended before the unlink came has been answered already.
    if (transfers_.contains(unlink.mapped())) finish(unlink.mapped(), UsbStatus::Cancelled, {}, 0);
    return {Parse::Status::Complete, usbip::kReplySize, ""};
}

void UsbipClient::finish(Sequence sequence, UsbStatus status, ByteView data, std::size_t actual) {
    const UsbCallback done = std::move(transfers_.extract(sequence).mapped().done);
    lastEnded_ = sequence;
    // A copy: the callback may destroy this, and the bytes with it.
    const std::vector<std::uint8_t> bytes(data.begin(), data.end());
    const std::weak_ptr alive(alive_);
    if (done) done({.status = status, .data = bytes, .actual = actual});
    if (!alive.expired() && status == UsbStatus::NoDevice)
        lose({.code = Errc::Disconnected, .subject = kSubject, .detail = "the device was unplugged"});
}

// ---- Transfers ----

UsbipClient::Sequence UsbipClient::control(const UsbSetup& setup, ByteView data, UsbCallback done) {
    Command command;
    // One without bytes has no direction but that of its status, which is IN for the bus and OUT for the
    // protocol.
    command.endpoint = setup.isIn() && setup.length > 0 ? 0x80 : 0x00;
    command.setup = setup;
    command.length = setup.length;
    command.data = data;
    return submit(command, std::move(done));
}

UsbipClient::Sequence UsbipClient::out(std::uint8_t endpoint, ByteView data, std::uint32_t interval,
                                       UsbCallback done) {
    Command command;
    command.endpoint = endpoint;
    command.length = static_cast<std::uint32_t>(data.size());
    command.data = data;
    command.interval = interval;
    return submit(command, std::move(done));
}

UsbipClient::Sequence UsbipClient::in(std::uint8_t endpoint, std::size_t size, std::uint32_t interval,
                                      UsbCallback done) {
    Command command;
    command.endpoint = endpoint;
    command.length = static_cast<std::uint32_t>(size);
    command.interval = interval;
    return submit(command, std::move(done));
}

UsbipClient::Sequence UsbipClient::submit(Command command, UsbCallback done) {
    command.sequence = nextSequence();
    Transfer& transfer = transfers_[command.sequence];
    transfer.isIn = isInEndpoint(command.endpoint);
    transfer.size = command.length;
    transfer.done = std::move(done);
    send(command);
    return command.sequence;
}

UsbipClient::Sequence UsbipClient::nextSequence() {
    do {
        ++lastSequence_;
    } while (lastSequence_ == 0 || transfers_.contains(lastSequence_) || unlinks_.contains(lastSequence_));
    return lastSequence_;
}

void UsbipClient::send(const Command& command) {
    Command addressed = command;
    addressed.device = device_;
    stream_->send(usbip::encodeCommand(addressed));
    if (stream_->unsent() <= kMaxUnsentBytes) return;
    scheduler_.post([this, alive = std::weak_ptr(alive_)] {
        if (alive.expired()) return;
        lose({.code = Errc::TimedOut, .subject = kSubject, .detail = "the server reads nothing"});
    });
}

void UsbipClient::unlink(Sequence sequence) {
    const auto found = transfers_.find(sequence);
    if (found == transfers_.end() || std::exchange(found->second.unlinked, true)) return;
    sendUnlink(sequence);
}

UsbipClient::Sequence UsbipClient::sendUnlink(Sequence sequence) {
    Command command;
    command.kind = Command::Kind::Unlink;
    command.sequence = nextSequence();
    command.unlink = sequence;
    unlinks_[command.sequence] = sequence;
    send(command);
    return command.sequence;
}

// ---- Silence and loss ----

void UsbipClient::tick() {
    ticker_ = scheduler_.callAfter(kTick, [this] { tick(); });
    if (phase_ == Phase::New || phase_ == Phase::Over) return;
    ++quietTicks_;
    const bool asking = phase_ == Phase::Listing || phase_ == Phase::Importing;
    const bool waiting = asking || !transfers_.empty() || !unlinks_.empty();
    if (!waiting) quietTicks_ = 0;
    if (quietTicks_ >= kTicksToLoss)
        return lose({.code = Errc::TimedOut, .subject = kSubject, .detail = "the server is silent"});
    // The first one at once: how far away the server is is of interest from the beginning.
    if (transfers_.empty() || --ticksToProbe_ > 0) return;
    ticksToProbe_ = kTicksBetweenProbes;
    probe();
}

void UsbipClient::probe() {
    if (lastEnded_ == 0 || !unlinks_.empty()) return;
    probe_ = sendUnlink(lastEnded_);
    probedAt_ = scheduler_.now();
}

void UsbipClient::lose(const Error& error) {
    if (phase_ == Phase::Over) return;
    phase_ = Phase::Over;
    stream_->close();
    if (const auto done = std::exchange(listed_, nullptr)) return done(fail(error));
    if (const auto done = std::exchange(imported_, nullptr)) return done(fail(error));
    const std::weak_ptr alive(alive_);
    loseTransfers();
    if (alive.expired()) return;
    if (const auto lost = std::exchange(lost_, nullptr)) lost(error);
}

void UsbipClient::loseTransfers() {
    const std::weak_ptr alive(alive_);
    unlinks_.clear();
    for (auto& [sequence, transfer] : std::exchange(transfers_, {})) {
        if (transfer.done) transfer.done({.status = UsbStatus::NoDevice});
        if (alive.expired()) return;
    }
}

}  // namespace kickstand
