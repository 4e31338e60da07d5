#include "core/framing/xbee_parser.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/framing/byte_places.h"
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

/// How many bytes there are before the first that API mode 2 marks.
std::size_t plainRun(ByteView bytes) noexcept {
    for (std::size_t i = 0; i < bytes.size(); i += kStripe) {
        const std::size_t here = std::min(kStripe, bytes.size() - i);
        const std::uint64_t marked =
            placesOf(bytes.data() + i, here, kDelimiter) | placesOf(bytes.data() + i, here, kEscape);
        if (marked != 0) return i + static_cast<std::size_t>(std::countr_zero(marked));
    }
    return bytes.size();
}

/// How far unescape() may read.
constexpr std::size_t kUnescapeReach = 3 * kStripe;

/// Makes `size` bytes of a line in API mode 2, and gives how many it took; 0 where they are not done after
/// two stripes, or are no data. Whole stripes are copied, which costs less than to count: behind `out` there
/// must be room for one.
std::size_t unescape(const std::uint8_t* line, std::size_t size, std::uint8_t* out) noexcept {
    std::size_t at = 0;
    std::size_t written = 0;
    for (std::size_t stripe = 0; stripe < 2 * kStripe; stripe += kStripe) {
        const std::uint64_t delimiters = placesOf(line + stripe, kDelimiter);
        std::uint64_t escapes = placesOf(line + stripe, kEscape);
        for (bool more = true; more; escapes &= escapes - 1) {
            more = escapes != 0;
            const std::size_t stop =
                stripe + (more ? static_cast<std::size_t>(std::countr_zero(escapes)) : kStripe);
            // The last byte of the stripe was an escape; any other that is escaped itself is damage.
            if (stop < at && !more) break;
            if (stop < at) return 0;
            std::memcpy(out + written, line + at, kStripe);
            if (written + stop - at >= size) {
                at += size - written;
                const std::uint64_t taken = (std::uint64_t{2} << (at - 1 - stripe)) - 1;
                return (delimiters & taken) == 0 ? at : 0;
            }
            written += stop - at;
            at = stop;
            if (!more) break;
            out[written++] = static_cast<std::uint8_t>(line[at + 1] ^ kEscapeMask);
            at += 2;
        }
        if (delimiters != 0) return 0;
    }
    return 0;
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

/// A frame that is whole in `input`, with so much behind it that whole stripes can be read: taken apart in
/// one go. Empty where it is anything else, and then nothing is taken.
ByteView Parser::nextWholeEscaped(ByteView& input) noexcept {
    if (input.size() < kHeader + kUnescapeReach || input[0] != kDelimiter || input[1] != 0) return {};
    const std::size_t length = input[2];
    if (!isLength(length)) return {};
    const std::size_t took = unescape(input.data() + kHeader, length + 1, whole_.data());
    if (took == 0 || !isWhole({whole_.data(), length + 1})) return {};
    ++counters_.frames;
    input = input.subspan(kHeader + took);
    return {whole_.data(), length};
}

ByteView Parser::nextEscaped(ByteView& input) noexcept {
    if (released_ > 0) held_.clear();
    released_ = 0;
    if (held_.empty()) {
        if (const ByteView data = nextWholeEscaped(input); !data.empty()) return data;
    }
    while (!input.empty()) {
        if (input[0] == kDelimiter) {
            beginHeld();
            input = input.subspan(1);
        } else if (held_.empty()) {
            const std::size_t junk = findDelimiter(input);
            counters_.skipped += junk;
            input = input.subspan(junk);
        } else if (escaping_) {
            held_.append(static_cast<std::uint8_t>(input[0] ^ kEscapeMask));
            escaping_ = false;
            input = input.subspan(1);
        } else if (input[0] == kEscape) {
            escaping_ = true;
            input = input.subspan(1);
        } else {
            const std::size_t run = plainRun(input.first(std::min(missing(), input.size())));
            held_.append(input.first(run));
            input = input.subspan(run);
        }
        if (const ByteView data = takeHeld(held_.size()); !data.empty()) return data;
    }
    return {};
}

/// A delimiter: what was in hold is broken off.
void Parser::beginHeld() noexcept {
    if (!held_.empty()) ++counters_.brokenOff;
    counters_.skipped += held_.size();
    held_.clear();
    held_.append(kDelimiter);
    escaping_ = false;
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
