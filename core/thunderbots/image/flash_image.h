#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kickstand::thunderbots::image {

/// The chip that an image is for. Both images travel through the robot's one SPI flash (protocol 6.7).
enum class FlashTarget : std::uint8_t { Microcontroller, Fpga };

/// What a file's bytes were written as.
enum class ImageFormat : std::uint8_t { IntelHex, Binary, XilinxBit };

/// Bytes of the SPI flash, and so of the longest image (protocol 6.7).
inline constexpr std::uint32_t kFlashBytes = 2 * 1024 * 1024;
/// Bytes of the microcontroller's own flash.
inline constexpr std::uint32_t kMicrocontrollerBytes = 0x20000;
/// The end of what the microcontroller copies into itself and signs; above it lie its parameters and
/// configuration.
inline constexpr std::uint32_t kMicrocontrollerCopiedBytes = 0x1F000;
/// What erased flash reads as, and what gaps of an image are filled with.
inline constexpr std::uint8_t kErased = 0xFF;

/// Addresses from `begin` to before `end` that a file has data for.
struct DataRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t line =
        0;  ///< The line of the file that `begin` stands in, from 1; 0 in a file without lines.

    std::uint32_t size() const { return end - begin; }
    friend bool operator==(const DataRange&, const DataRange&) = default;
};

/// Why an image is taken to be for one target rather than the other.
enum class GuessReason : std::uint8_t {
    BitHeader,    ///< The header of a Xilinx .bit file.
    SyncWord,     ///< The word by which an FPGA finds the start of its bitstream.
    ResetVector,  ///< The jump with which the microcontroller's firmware begins.
    Size,         ///< More than the microcontroller has room for.
    Form,         ///< Only the file's format: firmware mostly comes as Intel HEX, bitstreams do not.
};

/// What an image seems to be for.
struct TargetGuess {
    FlashTarget target = FlashTarget::Microcontroller;
    GuessReason reason = GuessReason::Form;

    /// Whether the bytes themselves show it, so that the other target would be a mistake.
    bool certain() const { return reason < GuessReason::Size; }
    friend bool operator==(const TargetGuess&, const TargetGuess&) = default;
};

/// What the header of a Xilinx .bit file says, each in printable ASCII; empty for other files.
struct BitHeader {
    std::string design;
    std::string part;
    std::string date;
    std::string time;
    friend bool operator==(const BitHeader&, const BitHeader&) = default;
};

/// What is to be in the SPI flash, from address 0 on. Immutable once made, so that threads may share it.
struct FlashImage {
    ImageFormat format = ImageFormat::Binary;
    FlashTarget target = FlashTarget::Microcontroller;  ///< The guess, until forTarget() has settled it.
    TargetGuess guess;
    std::vector<std::uint8_t> bytes;  ///< Ends with the last byte of data; gaps are kErased.
    std::vector<DataRange> data;      ///< Ascending, apart from each other, not empty.
    std::vector<DataRange> skipped;   ///< What the file has and the target does not take (protocol 6.7).
    BitHeader header;

    /// How many bytes of the file are to be in flash: gaps and what is skipped do not count.
    std::uint32_t dataBytes() const;
    friend bool operator==(const FlashImage&, const FlashImage&) = default;
};

/// What a robot that holds an image answers to Read Build Signatures (protocol 4.7, 6.7).
struct ImageSignatures {
    std::uint16_t microcontroller = 0;  ///< CRC of 0-0x1EFFF of the image, padded: its firmware's signature.
    std::uint16_t flash = 0;            ///< CRC of all 2 MiB of flash with nothing but the image in it.
    friend bool operator==(const ImageSignatures&, const ImageSignatures&) = default;
};

/// Computes both; takes some milliseconds. Any thread.
ImageSignatures signaturesOf(const FlashImage& image);

/// "microcontroller", "fpga"; "intel-hex", "binary", "xilinx-bit"; "bit-header", …: stable names for JSON.
/// Any thread.
const char* name(FlashTarget target);
const char* name(ImageFormat format);
const char* name(GuessReason reason);

}  // namespace kickstand::thunderbots::image
