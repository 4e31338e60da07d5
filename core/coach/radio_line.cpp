#include "core/coach/radio_line.h"

#include <utility>

namespace kickstand::coach {
namespace {

bool isPlain(const xbee::Frame& frame) {
    const xbee::FrameData data = xbee::encodeFrame(frame);
    return xbee::wrapFrame(data.view(), xbee::ApiMode::Escaped).size() ==
           xbee::wrapFrame(data.view(), xbee::ApiMode::Plain).size();
}

/// Whether a question, and its answer from a module in API mode 2, are the same bytes in both API modes.
bool readsTheSame(const xbee::AtCommand& question) {
    constexpr std::array kEscapedMode{static_cast<std::uint8_t>(ModuleMode::ApiEscaped)};
    const auto ok = static_cast<std::uint8_t>(xbee::AtOutcome::Ok);
    return isPlain(question) && isPlain(xbee::AtResponse{question.frameId, question.name, ok, kEscapedMode});
}

}  // namespace

RadioLine::RadioLine(Scheduler& scheduler, ByteLink& link, Listener listener)
    : scheduler_(scheduler), link_(link), listener_(std::move(listener)) {
    link_.setReceiver([this](ByteView bytes) { received(bytes); });
}

RadioLine::~RadioLine() {
    link_.setReceiver({});
}

void RadioLine::setMode(ModuleMode mode) {
    mode_ = mode;
    parser_.reset(mode == ModuleMode::ApiEscaped ? xbee::ApiMode::Escaped : xbee::ApiMode::Plain);
    ++version_;
}

std::uint8_t RadioLine::nextFrameId() {
    // 0 asks for no answer.
    if (++lastFrameId_ == 0) ++lastFrameId_;
    return lastFrameId_;
}

void RadioLine::write(const xbee::Frame& frame) {
    const xbee::LineFrame line =
        xbee::wrapFrame(xbee::encodeFrame(frame).view(),
                        mode_ == ModuleMode::ApiEscaped ? xbee::ApiMode::Escaped : xbee::ApiMode::Plain);
    // A line that is gone or full loses it, as the radio may; who waits for an answer asks again.
    static_cast<void>(link_.write(line.view()));
    ++version_;
}

void RadioLine::send(std::uint16_t destination, const wire::Message& message) {
    const auto bytes = wire::encodeMessage(message);
    const std::uint8_t id = nextFrameId();
    TrafficEntry entry;
    entry.sent = true;
    entry.address = destination;
    entry.message = message;
    entry.frameId = id;
    remember(entry);
    write(xbee::Tx16{id, destination, 0, bytes});
}

std::uint8_t RadioLine::sendAt(std::array<char, 2> name, ByteView value) {
    xbee::AtCommand command{nextFrameId(), name, value};
    // Which mode the module is in is what is asked first: the number decides whether frame and answer hold a
    // byte, the checksum if nothing else, that the two modes write differently.
    while (value.empty() && !readsTheSame(command))
        command.frameId = nextFrameId();
    write(command);
    return command.frameId;
}

void RadioLine::sendText(std::string_view text) {
    static_cast<void>(link_.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

void RadioLine::received(ByteView bytes) {
    if (mode_ == ModuleMode::Transparent) {
        listener_.text(bytes);
        return;
    }
    ++version_;
    while (mode_ != ModuleMode::Transparent) {
        const ByteView data = parser_.next(bytes);
        if (data.empty()) break;
        if (const auto frame = xbee::decodeFrame(data)) {
            take(*frame);
        } else {
            ++counters_.notMessages;
        }
    }
    counters_.frames = parser_.counters();
}

void RadioLine::take(const xbee::Frame& frame) {
    if (const auto* packet = std::get_if<xbee::Rx16>(&frame)) {
        take(*packet);
    } else if (const auto* status = std::get_if<xbee::TxStatus>(&frame)) {
        take(*status);
    } else if (const auto* response = std::get_if<xbee::AtResponse>(&frame)) {
        listener_.atResponse(*response);
    } else if (const auto* modem = std::get_if<xbee::ModemStatus>(&frame)) {
        listener_.modemStatus(modem->status);
    }
}

void RadioLine::take(const xbee::Rx16& packet) {
    const auto message = wire::decodeMessage(packet.payload);
    if (!message) {
        ++counters_.notMessages;
        return;
    }
    TrafficEntry entry;
    entry.address = packet.source;
    entry.rssi_dBm = packet.rssi_dBm;
    entry.message = *message;
    remember(entry);
    listener_.message(Received{packet.source, packet.rssi_dBm, *message});
}

void RadioLine::take(const xbee::TxStatus& status) {
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
        if (!entry->sent || entry->frameId != status.frameId || entry->outcome) continue;
        entry->outcome = status.status;
        published_.reset();
        ++(status.status == 0 ? counters_.acknowledged : counters_.failed);
        return;
    }
    ++counters_.strayStatuses;
}

void RadioLine::remember(TrafficEntry entry) {
    entry.number = ++lastNumber_;
    entry.time = scheduler_.now();
    entries_.push_back(entry);
    if (entries_.size() > kRemembered) entries_.pop_front();
    published_.reset();
    ++version_;
}

std::shared_ptr<const TrafficEntries> RadioLine::entries() const {
    if (!published_) published_ = std::make_shared<const TrafficEntries>(entries_);
    return published_;
}

}  // namespace kickstand::coach
