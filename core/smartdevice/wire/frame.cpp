#include "core/smartdevice/wire/frame.h"

#include <array>

namespace kickstand::smartdevice::wire {
namespace {

constexpr std::uint8_t kDelimiter = 0;

}  // namespace

FrameBytes encodeFrame(Dialect dialect, const Message& message) noexcept {
    const MessageBytes bytes = encodeMessage(dialect, message);
    std::array<std::uint8_t, kMostCobs> cobs{};
    const std::size_t size = cobsEncode(bytes.view(), cobs);
    FrameBytes frame;
    if (dialect == Dialect::Hibike) {
        frame.append(kDelimiter);
        frame.append(static_cast<std::uint8_t>(size));
    }
    frame.append(ByteView(cobs).first(size));
    if (dialect == Dialect::Current) frame.append(kDelimiter);
    return frame;
}

void Decoder::reset() noexcept {
    counts_.dropped += frame_.size();
    frame_.clear();
    begun_ = false;
    overlong_ = false;
}

void Decoder::feed(ByteView bytes, const Sink& sink) {
    for (const std::uint8_t byte : bytes) {
        if (dialect_ == Dialect::Current)
            feedCurrent(byte, sink);
        else
            feedHibike(byte, sink);
    }
}

void Decoder::feedCurrent(std::uint8_t byte, const Sink& sink) {
    if (byte != kDelimiter) {
        if (overlong_)
            ++counts_.dropped;
        else if (!frame_.append(byte)) {
            damage();
            ++counts_.dropped;
            overlong_ = true;
        }
        return;
    }
    overlong_ = false;
    if (!frame_.empty()) finish(sink);
}

void Decoder::feedHibike(std::uint8_t byte, const Sink& sink) {
    if (byte == kDelimiter) {
        // In the middle of a frame it is the beginning of the next one.
        if (begun_ && awaited_ > 0) damage();
        begun_ = true;
        awaited_ = 0;
    } else if (!begun_) {
        ++counts_.dropped;
    } else if (awaited_ == 0) {
        awaited_ = byte;
    } else {
        frame_.append(byte);
        if (frame_.size() < awaited_) return;
        begun_ = false;
        finish(sink);
    }
}

void Decoder::damage() {
    ++counts_.damaged;
    counts_.dropped += frame_.size();
    frame_.clear();
}

void Decoder::finish(const Sink& sink) {
    std::array<std::uint8_t, kMostCobs> bytes{};
    const auto size = cobsDecode(frame_.view(), bytes);
    if (!size) return damage();
    const auto message = decodeMessage(dialect_, ByteView(bytes).first(*size));
    const std::size_t taken = frame_.size();
    frame_.clear();
    if (message) {
        ++counts_.messages;
        return sink(*message);
    }
    ++(message.error() == MessageFault::BadChecksum ? counts_.checksums : counts_.malformed);
    counts_.dropped += taken;
}

}  // namespace kickstand::smartdevice::wire
