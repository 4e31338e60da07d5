#include "core/thunderbots/image/intel_hex.h"

#include <algorithm>
#include <array>

namespace kickstand::thunderbots::image {
namespace {

enum class RecordType : std::uint8_t { Data, End, SegmentBase, SegmentStart, LinearBase, LinearStart };

/// Length, address (2) and type before a record's data; the checksum behind it.
constexpr std::size_t kAroundData = 5;
constexpr std::size_t kMostData = 255;

/// A line's bytes, whole and with the right checksum.
struct Record {
    std::array<std::uint8_t, kAroundData + kMostData> bytes{};

    std::size_t length() const { return bytes[0]; }
    std::uint16_t offset() const { return loadBe16(bytes, 1); }
    std::uint8_t type() const { return bytes[3]; }
    ByteView data() const { return ByteView(bytes).subspan(4, length()); }
};

int digitOf(std::uint8_t character) {
    if (character >= '0' && character <= '9') return character - '0';
    const int lower = character | 0x20;
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

bool isBlank(std::uint8_t character) {
    return character == ' ' || character == '\t';
}

ByteView trimmed(ByteView line) {
    while (!line.empty() && isBlank(line.back()))
        line = line.first(line.size() - 1);
    return line;
}

/// Goes through the records of a file, one line after another.
class HexReader {
  public:
    ImageResult<ImageData> read(ByteView file) {
        while (!file.empty()) {
            const ByteView line = trimmed(takeLine(file));
            ++line_;
            if (line.empty()) continue;
            if (ended_) return refuse(ImageFault::AfterEnd);
            const auto record = readRecord(line);
            if (!record) return tl::unexpected(record.error());
            if (const auto done = take(*record); !done) return tl::unexpected(done.error());
        }
        if (!ended_) return refuse(ImageFault::MissingEnd);
        return builder_.take();
    }

  private:
    tl::unexpected<ImageError> refuse(ImageFault fault, std::size_t got = 0, std::size_t most = 0) const {
        ImageError error;
        error.fault = fault;
        error.line = line_;
        error.got = static_cast<std::uint32_t>(got);
        error.most = static_cast<std::uint32_t>(most);
        return tl::unexpected(error);
    }

    /// The next line without its end, which is LF, CR or CR LF.
    static ByteView takeLine(ByteView& rest) {
        std::size_t length = 0;
        while (length < rest.size() && rest[length] != '\n' && rest[length] != '\r')
            ++length;
        const ByteView line = rest.first(length);
        rest = rest.subspan(length);
        if (rest.size() >= 2 && rest[0] == '\r' && rest[1] == '\n') {
            rest = rest.subspan(2);
        } else if (!rest.empty()) {
            rest = rest.subspan(1);
        }
        return line;
    }

    ImageResult<Record> readRecord(ByteView line) const {
        if (line[0] != ':') return refuse(ImageFault::Junk, 1);
        for (std::size_t at = 1; at < line.size(); ++at) {
            if (digitOf(line[at]) < 0) return refuse(ImageFault::Junk, at + 1);
        }
        const std::size_t digits = line.size() - 1;
        Record record;
        if (digits / 2 > record.bytes.size())
            return refuse(ImageFault::BadLength, digits, 2 * record.bytes.size());
        for (std::size_t i = 0; i < digits / 2; ++i) {
            record.bytes[i] =
                static_cast<std::uint8_t>(digitOf(line[1 + 2 * i]) << 4 | digitOf(line[2 + 2 * i]));
        }
        const std::size_t wanted = kAroundData + record.length();
        if (digits != 2 * wanted) return refuse(ImageFault::BadLength, digits, 2 * wanted);
        std::uint8_t sum = 0;
        for (std::size_t i = 0; i + 1 < wanted; ++i)
            sum = static_cast<std::uint8_t>(sum + record.bytes[i]);
        const auto checksum = static_cast<std::uint8_t>(0x100 - sum);
        const std::uint8_t given = record.bytes[wanted - 1];
        if (given != checksum) return refuse(ImageFault::BadChecksum, given, checksum);
        return record;
    }

    ImageResult<void> take(const Record& record) {
        const auto lengthIs = [&](std::size_t wanted) -> ImageResult<void> {
            if (record.length() == wanted) return {};
            return refuse(ImageFault::BadLength, 2 * (kAroundData + record.length()),
                          2 * (kAroundData + wanted));
        };
        switch (static_cast<RecordType>(record.type())) {
            case RecordType::Data:
                return takeData(record);
            case RecordType::End:
                ended_ = true;
                return lengthIs(0);
            case RecordType::SegmentBase:
            case RecordType::LinearBase: {
                if (auto right = lengthIs(2); !right) return right;
                segmented_ = static_cast<RecordType>(record.type()) == RecordType::SegmentBase;
                base_ = static_cast<std::uint32_t>(loadBe16(record.bytes, 4)) << (segmented_ ? 4 : 16);
                return {};
            }
            case RecordType::SegmentStart:
            case RecordType::LinearStart:
                return lengthIs(4);
        }
        return refuse(ImageFault::UnknownType, record.type());
    }

    ImageResult<void> takeData(const Record& record) {
        const ByteView data = record.data();
        // Inside a segment addresses begin anew behind 64 KiB; linear ones go on.
        const std::size_t room = 0x10000U - record.offset();
        const std::size_t first = segmented_ ? std::min(room, data.size()) : data.size();
        if (auto added = add(base_ + record.offset(), data.first(first)); !added) return added;
        return add(base_, data.subspan(first));
    }

    ImageResult<void> add(std::uint32_t address, ByteView piece) {
        return builder_.add(address, piece, line_);
    }

    ImageBuilder builder_;
    std::uint32_t line_ = 0;
    std::uint32_t base_ = 0;
    bool segmented_ = false;
    bool ended_ = false;
};

}  // namespace

ImageResult<ImageData> readIntelHex(ByteView file) {
    return HexReader().read(file);
}

}  // namespace kickstand::thunderbots::image
