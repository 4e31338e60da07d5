#include "core/framing/xbee_parser.h"

#include <algorithm>
#include <cstring>

#include "core/framing/byte_sum.h"

namespace kickstand::xbee {
namespace {

/// Where the first delimiter is; the size where there is none.
std::size_t findDelimiter(ByteView bytes) noexcept {
    if (bytes.empty() || bytes[0] == kDelimiter) return 0;
    const void* found = std::memchr(bytes.data(), kDelimiter, bytes.size());
    if (found == nullptr) return bytes.size();
    return static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - bytes.data());
}

bool isLength(std::size_t length) noexcept {
    return length - 1 < kMaxFrameData;
}

/// Whether data and the checksum behind it belong together.
bool isWhole(ByteView dataAndChecksum) noexcept {
    return (byteSum(dataAndChecksum) & 0xFF) == 0xFF;
}

}  // namespace

ByteView Parser::next(ByteView& input) noexcept {
    return mode_ == ApiMode::Plain ? nextPlain(input) : nextEscaped(input);
}

void Parser::reset(ApiMode mode) noexcept {
    mode_ = mode;
    counters_.skipped += held_.size() - released_;
    held_.clear();
    released_ = 0;
    escaping_ = false;
}

/// The first whole frame in `input`. `used` is what it and everything before it takes; where there is none,
/// what comes before a frame that has begun.
ByteView Parser::scan(ByteView input, std::size_t& used) noexcept {
    used = 0;
    while (true) {
        const std::size_t junk = findDelimiter(input.subspan(used));
        counters_.skipped += junk;
        used += junk;
        const ByteView rest = input.subspan(used);
        if (rest.size() < kHeader) return {};
        const std::size_t length = loadBe16(rest, 1);
        if (!isLength(length)) {
            ++counters_.badLength;
        } else if (rest.size() < kHeader + length + 1) {
            return {};
        } else if (isWhole(rest.subspan(kHeader, length + 1))) {
            ++counters_.frames;
            used += kHeader + length + 1;
            return rest.subspan(kHeader, length);
        } else {
            ++counters_.badChecksum;
        }
        ++counters_.skipped;
        ++used;
    }
}

/// How many bytes the frame in hold needs before anything more can be said of it.
std::size_t Parser::missing() const noexcept {
    if (held_.size() < kHeader) return kHeader - held_.size();
    const std::size_t length = loadBe16(held_.view(), 1);
    const std::size_t whole = kHeader + length + 1;
    return whole > held_.size() ? whole - held_.size() : 0;
}

void Parser::dropHeld(std::size_t count) noexcept {
    const ByteSpan bytes = held_.span();
    std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(count), bytes.end(), bytes.begin());
    held_.resize(bytes.size() - count);
}

ByteView Parser::nextPlain(ByteView& input) noexcept {
    // The usual case first: a whole frame in one piece, looked at where it is.
    if (held_.empty() && input.size() > kHeader && input[0] == kDelimiter) {
        const std::size_t length = loadBe16(input, 1);
        if (isLength(length) && input.size() > kHeader + length &&
            isWhole(input.subspan(kHeader, length + 1))) {
            const ByteView data = input.subspan(kHeader, length);
            ++counters_.frames;
            input = input.subspan(kHeader + length + 1);
            return data;
        }
    }
    if (released_ > 0) {
        dropHeld(released_);
        released_ = 0;
    }
    std::size_t used = 0;
    while (!held_.empty()) {
        // A frame that is inside a damaged one may be whole already.
        if (const ByteView data = scan(held_.view(), used); !data.empty()) {
            released_ = used;
            return data;
        }
        dropHeld(used);
        if (held_.empty()) break;
        if (input.empty()) return {};
        const std::size_t more = std::min(missing(), input.size());
        held_.append(input.first(more));
        input = input.subspan(more);
    }
    const ByteView data = scan(input, used);
    if (data.empty()) held_.append(input.subspan(used));
    input = data.empty() ? ByteView() : input.subspan(used);
    return data;
}

ByteView Parser::nextEscaped(ByteView& input) noexcept {
    if (released_ > 0) held_.clear();
    released_ = 0;
    while (!input.empty()) {
        std::uint8_t byte = input[0];
        input = input.subspan(1);
        if (byte == kDelimiter) {
            if (!held_.empty()) {
                ++counters_.brokenOff;
                counters_.skipped += held_.size();
            }
            held_.clear();
            held_.append(byte);
            escaping_ = false;
            continue;
        }
        if (held_.empty()) {
            ++counters_.skipped;
            continue;
        }
        if (byte == kEscape && !escaping_) {
            escaping_ = true;
            continue;
        }
        if (escaping_) byte = static_cast<std::uint8_t>(byte ^ kEscapeMask);
        escaping_ = false;
        held_.append(byte);
        if (const ByteView data = takeHeld(held_.size()); !data.empty()) return data;
    }
    return {};
}

/// The data of the frame in hold, once it is whole and right. Drops it where it is wrong.
ByteView Parser::takeHeld(std::size_t size) noexcept {
    if (size < kHeader) return {};
    const std::size_t length = loadBe16(held_.view(), 1);
    const bool tooLong = !isLength(length);
    if (!tooLong && size < kHeader + length + 1) return {};
    const ByteView data = tooLong ? ByteView() : held_.view().subspan(kHeader, length);
    if (!tooLong && isWhole(held_.view().subspan(kHeader, length + 1))) {
        ++counters_.frames;
        released_ = size;
        return data;
    }
    ++(tooLong ? counters_.badLength : counters_.badChecksum);
    counters_.skipped += size;
    held_.clear();
    return {};
}

}  // namespace kickstand::xbee
