#include "core/usbip/usbip_connection.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

using usbip::Command;
using usbip::OpStatus;
using usbip::Parse;
using usbip::TransferStatus;

constexpr std::uint8_t kEndpointNumber = 0x0F;
constexpr std::uint8_t kSetConfiguration = 9;

TransferStatus statusOf(UsbStatus status) {
    switch (status) {
        case UsbStatus::Completed:
            return TransferStatus::Ok;
        case UsbStatus::Stalled:
            return TransferStatus::Stall;
        case UsbStatus::TimedOut:
            return TransferStatus::TimedOut;
        case UsbStatus::Cancelled:
            return TransferStatus::Reset;
        case UsbStatus::NoDevice:
            return TransferStatus::Shutdown;
        case UsbStatus::Overflow:
            return TransferStatus::Overflow;
        case UsbStatus::Failed:
            break;
    }
    // An endpoint that is not there: on a bus nobody would answer.
    return TransferStatus::Protocol;
}

/// Whether the setup packet of a control transfer fits the direction and the bytes that came with it. One
/// without a data stage may be said to go either way.
bool fits(const Command& command) {
    if (!command.setup.isIn()) return command.data.size() == command.setup.length;
    return command.data.empty() && (isInEndpoint(command.endpoint) || command.setup.length == 0);
}

}  // namespace

UsbipConnection::UsbipConnection(Scheduler& scheduler, std::unique_ptr<ByteStream> stream, UsbipHall& hall,
                                 const UsbipLimits& limits, std::function<void()> ended)
    : scheduler_(scheduler),
      stream_(std::move(stream)),
      hall_(hall),
      limits_(limits),
      ended_(std::move(ended)),
      number_(++hall.report.connections) {
    silenceTimer_ = scheduler_.callAfter(limits_.silence, [this] { endOverrun("it said nothing"); });
    stream_->start({.received = [this](ByteView bytes) { received(bytes); },
                    .closed = [this](const Error&) { end("left"); }});
}

UsbipConnection::~UsbipConnection() {
    if (!over_) leave();
}

// ---- Messages ----

void UsbipConnection::received(ByteView bytes) {
    unread_.insert(unread_.end(), bytes.begin(), bytes.end());
    std::size_t taken = 0;
    while (!over_) {
        const Parse parse = takeMessage(ByteView(unread_).subspan(taken));
        if (parse.status == Parse::Status::Malformed) return endMalformed(parse.why);
        if (parse.status == Parse::Status::MoreNeeded) break;
        taken += parse.bytes;
    }
    // A message is bounded by its parser, so what is kept here is too.
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(taken));
}

Parse UsbipConnection::takeMessage(ByteView bytes) {
    return imported_ || unpluggedAt_ ? takeCommand(bytes) : takeRequest(bytes);
}

Parse UsbipConnection::takeRequest(ByteView bytes) {
    usbip::Request request;
    const Parse parse = usbip::parseRequest(bytes, request);
    if (parse.status != Parse::Status::Complete) return parse;
    scheduler_.cancel(silenceTimer_);
    if (request.kind == usbip::Request::Kind::List) {
        listDevices();
    } else {
        import(request.busId);
    }
    return parse;
}

Parse UsbipConnection::takeCommand(ByteView bytes) {
    Command command;
    const Parse parse = usbip::parseCommand(bytes, command);
    if (parse.status != Parse::Status::Complete) return parse;
    if (command.device != deviceId_) return {Parse::Status::Malformed, 0, "a command for another device"};
    if (unpluggedAt_) {
        refuse(command);
        return parse;
    }
    if (command.kind == Command::Kind::Unlink) {
        unlink(command);
        return parse;
    }
    if (transfers_.contains(command.sequence))
        return {Parse::Status::Malformed, 0, "a sequence number that is in use"};
    submit(command);
    return parse;
}

void UsbipConnection::listDevices() {
    send(usbip::encodeDeviceList(hall_.exports.present()));
    // Whoever waits for a device asks for the list again and again: nothing to tell of.
    end({});
}

void UsbipConnection::import(const std::string& busId) {
    UsbipExports::Entry* const entry = hall_.exports.find(busId);
    OpStatus status = OpStatus::Ok;
    if (!entry || !entry->model->attached()) {
        status = OpStatus::NoDevice;
    } else if (entry->taken) {
        status = OpStatus::Busy;
    }
    if (status != OpStatus::Ok) {
        send(usbip::encodeImportReply(status, {}));
        // Likewise whoever waits for one that is in use.
        return end(status == OpStatus::Busy ? std::string() : "asked for a device that is not there");
    }
    entry->taken = true;
    imported_ = entry;
    deviceId_ = entry->device.id();
    controller_ = std::make_unique<UsbHostController>(scheduler_, *entry->model);
    controller_->setAttachedListener([this](bool attached) { attachedChanged(attached); });
    ++hall_.report.imports;
    log("imported " + entry->device.busId);
    send(usbip::encodeImportReply(status, entry->device));
}

// ---- The unplugged device ----

void UsbipConnection::attachedChanged(bool attached) {
    if (attached) return;
    // After the answers to what it was doing.
    controller_->later([this] {
        log("lost its device, which was unplugged");
        unpluggedAt_ = scheduler_.now();
        releaseDevice();
        lingerOn();
    });
}

void UsbipConnection::lingerOn() {
    scheduler_.cancel(quietTimer_);
    const Duration left = *unpluggedAt_ + limits_.quietMost - scheduler_.now();
    quietTimer_ = scheduler_.callAfter(std::clamp(left, Duration::zero(), limits_.quiet),
                                       [this] { end("was let go"); });
}

void UsbipConnection::refuse(const Command& command) {
    lingerOn();
    const TransferStatus status =
        command.kind == Command::Kind::Unlink ? TransferStatus::Ok : TransferStatus::Shutdown;
    reply({command.kind, command.sequence, status, 0});
}

// ---- Transfers ----

void UsbipConnection::submit(const Command& command) {
    if (transfers_.size() >= limits_.transfers) return endOverrun("it asked for too much at once");
    ++hall_.report.transfers;
    const std::uint32_t sequence = command.sequence;
    const bool isControl = (command.endpoint & kEndpointNumber) == 0;
    if (isControl && !fits(command))
        return reply({Command::Kind::Submit, sequence, TransferStatus::Invalid, 0});
    Transfer& transfer = transfers_[sequence];
    transfer.isIn = isInEndpoint(command.endpoint);
    auto done = [this, sequence](const UsbCompletion& completion) { finished(sequence, completion); };
    transfer.id = isControl ? startControl(command, std::move(done)) : start(command, std::move(done));
}

UsbTransferId UsbipConnection::start(const Command& command, UsbCallback done) {
    if (isInEndpoint(command.endpoint))
        return controller_->in(command.endpoint, command.length, std::move(done));
    const bool zeroPacket = (command.flags & usbip::kZeroPacketFlag) != 0;
    return controller_->out(command.endpoint, command.data, zeroPacket, std::move(done));
}

UsbTransferId UsbipConnection::startControl(const Command& command, UsbCallback done) {
    UsbSetup setup = command.setup;
    // The client has room for `length` bytes, whatever the setup packet says.
    if (setup.isIn())
        setup.length = static_cast<std::uint16_t>(std::min<std::uint32_t>(setup.length, command.length));
    return controller_->control(setup, command.data, std::move(done));
}

void UsbipConnection::finished(std::uint32_t sequence, const UsbCompletion& completion) {
    const auto found = transfers_.extract(sequence);
    const Transfer& transfer = found.mapped();
    if (transfer.unlinkedBy) {
        ++hall_.report.unlinked;
        return reply({Command::Kind::Unlink, *transfer.unlinkedBy, TransferStatus::Reset, 0});
    }
    reply({Command::Kind::Submit, sequence, statusOf(completion.status),
           static_cast<std::uint32_t>(completion.actual)},
          transfer.isIn ? completion.data : ByteView());
}

void UsbipConnection::unlink(const Command& command) {
    const auto found = transfers_.find(command.unlink);
    if (found != transfers_.end() && controller_->cancel(found->second.id)) {
        found->second.unlinkedBy = command.sequence;
        return;
    }
    // After the answer to the transfer, which may still be on its way out: a client that hears of the unlink
    // first takes the transfer's answer for one to a question that it never asked.
    controller_->later([this, sequence = command.sequence] {
        reply({Command::Kind::Unlink, sequence, TransferStatus::Ok, 0});
    });
}

// ---- Answers and ends ----

void UsbipConnection::reply(const usbip::Reply& reply, ByteView data) {
    send(usbip::encodeReply(reply, data));
}

void UsbipConnection::send(ByteView bytes) {
    if (over_) return;
    stream_->send(bytes);
    if (stream_->unsent() > limits_.unsentBytes) endOverrun("it does not read its answers");
}

void UsbipConnection::endMalformed(const std::string& why) {
    ++hall_.report.malformed;
    end("was cut off: " + why);
}

void UsbipConnection::endOverrun(const std::string& why) {
    ++hall_.report.overrun;
    end("was cut off: " + why);
}

void UsbipConnection::end(const std::string& why) {
    if (over_) return;
    if (!why.empty()) log(why);
    leave();
    scheduler_.post([this, alive = std::weak_ptr(alive_)] {
        if (!alive.expired()) std::exchange(ended_, nullptr)();
    });
}

void UsbipConnection::leave() {
    over_ = true;
    scheduler_.cancel(silenceTimer_);
    scheduler_.cancel(quietTimer_);
    stream_->close();
    releaseDevice();
}

void UsbipConnection::releaseDevice() {
    transfers_.clear();
    controller_.reset();
    UsbipExports::Entry* const entry = std::exchange(imported_, nullptr);
    if (!entry) return;
    entry->taken = false;
    if (!entry->model->attached()) return;
    UsbSetup unconfigure;
    unconfigure.request = kSetConfiguration;
    std::vector<std::uint8_t> nothing;
    entry->model->control(unconfigure, {}, nothing);
}

void UsbipConnection::log(const std::string& what) const {
    if (hall_.log) hall_.log("client " + std::to_string(number_) + " " + what);
}

}  // namespace kickstand
