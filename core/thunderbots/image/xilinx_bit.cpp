#include "core/thunderbots/image/xilinx_bit.h"

#include <algorithm>
#include <array>

namespace kickstand::thunderbots::image {
namespace {

/// The first field (nine bytes, always these) and the length of the key that follows.
constexpr std::array<std::uint8_t, 13> kPreamble{0x00, 0x09, 0x0F, 0xF0, 0x0F, 0xF0, 0x0F,
                                                 0xF0, 0x0F, 0xF0, 0x00, 0x00, 0x01};
constexpr std::size_t kLongestText = 255;

/// Takes a header apart from front to back; what cannot be read is where it stands still.
class HeaderReader {
  public:
    explicit HeaderReader(ByteView file) : file_(file) {}

    std::size_t at() const { return at_; }
    std::size_t left() const { return file_.size() - at_; }
    ByteView rest() const { return file_.subspan(at_); }

    bool preamble() {
        if (!beginsAsBit(file_)) return false;
        at_ = kPreamble.size();
        return true;
    }

    bool key(char key) {
        if (left() < 1 || file_[at_] != static_cast<std::uint8_t>(key)) return false;
        ++at_;
        return true;
    }

    /// A text with its length before it and a zero byte at its end, which the length counts.
    bool text(char itsKey, std::string& text) {
        if (!key(itsKey) || left() < 2) return false;
        const std::size_t length = loadBe16(file_, at_);
        if (length == 0 || length > kLongestText + 1 || length > left() - 2) return false;
        const ByteView bytes = file_.subspan(at_ + 2, length - 1);
        const bool printable =
            std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte >= 0x20 && byte < 0x7F; });
        if (!printable || file_[at_ + 1 + length] != 0) return false;
        text.assign(bytes.begin(), bytes.end());
        at_ += 2 + length;
        return true;
    }

    bool length(std::uint32_t& length) {
        if (!key('e') || left() < 4) return false;
        length = loadBe32(file_, at_);
        at_ += 4;
        return true;
    }

  private:
    ByteView file_;
    std::size_t at_ = 0;
};

tl::unexpected<ImageError> refuse(ImageFault fault, std::size_t got, std::size_t most = 0) {
    ImageError error;
    error.fault = fault;
    error.got = static_cast<std::uint32_t>(got);
    error.most = static_cast<std::uint32_t>(most);
    return tl::unexpected(error);
}

}  // namespace

bool beginsAsBit(ByteView file) {
    return file.size() >= kPreamble.size() && std::ranges::equal(file.first(kPreamble.size()), kPreamble);
}

ImageResult<BitFile> readXilinxBit(ByteView file) {
    HeaderReader in(file);
    BitFile bit;
    std::uint32_t length = 0;
    const bool whole = in.preamble() && in.text('a', bit.header.design) && in.text('b', bit.header.part) &&
                       in.text('c', bit.header.date) && in.text('d', bit.header.time) && in.length(length);
    if (!whole) return refuse(ImageFault::BadHeader, in.at());
    if (in.left() != length) return refuse(ImageFault::BadLength, in.left(), length);
    bit.data = in.rest();
    return bit;
}

}  // namespace kickstand::thunderbots::image
