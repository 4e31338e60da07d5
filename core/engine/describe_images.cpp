#include "core/engine/describe_images.h"

#include <QCoreApplication>

namespace kickstand {
namespace {

namespace image = thunderbots::image;
using image::ImageFault;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Image)
};

QString hexByte(std::uint32_t byte) {
    return QStringLiteral("0x%1").arg(byte, 2, 16, QLatin1Char('0'));
}

QString pastEnd(const image::ImageError& error) {
    const QString last =
        error.target == image::FlashTarget::Fpga
            ? Words::tr("the last address of the flash is %1.").arg(addressText(error.most))
            : Words::tr("the last address of the microcontroller is %1.").arg(addressText(error.most));
    const QString where =
        error.line == 0
            ? Words::tr("There is data at address %1;").arg(addressText(error.address))
            : Words::tr("Line %1 has data for address %2;").arg(error.line).arg(addressText(error.address));
    return where + QLatin1Char(' ') + last;
}

QString whatIsWrong(const image::ImageError& error) {
    switch (error.fault) {
        case ImageFault::TooLarge:
            return Words::tr("The file has %1 bytes; no firmware file has more than %2.")
                .arg(error.got)
                .arg(error.most);
        case ImageFault::Empty:
            return Words::tr("There is no data in the file that the robot would take.");
        case ImageFault::Junk:
            return Words::tr("Line %1 is no Intel HEX record: character %2 does not belong there.")
                .arg(error.line)
                .arg(error.got);
        case ImageFault::BadLength:
            if (error.line == 0)
                return Words::tr("The bitstream has %1 bytes where its header promises %2.")
                    .arg(error.got)
                    .arg(error.most);
            return Words::tr("Line %1 has %2 hex digits where %3 belong.")
                .arg(error.line)
                .arg(error.got)
                .arg(error.most);
        case ImageFault::BadChecksum:
            return Words::tr("Line %1 is damaged: its checksum is %2, and its bytes give %3.")
                .arg(error.line)
                .arg(hexByte(error.got), hexByte(error.most));
        case ImageFault::UnknownType:
            return Words::tr("Line %1 has record type %2, which Intel HEX does not have.")
                .arg(error.line)
                .arg(error.got);
        case ImageFault::Overlap:
            return Words::tr("Line %1 has data for address %2, which has some already.")
                .arg(error.line)
                .arg(addressText(error.address));
        case ImageFault::MissingEnd:
            return Words::tr("The file has been cut off: its end record is missing.");
        case ImageFault::AfterEnd:
            return Words::tr("Something follows the end record, in line %1.").arg(error.line);
        case ImageFault::PastEnd:
            return pastEnd(error);
        case ImageFault::BadHeader:
            return Words::tr("The header of the .bit file cannot be read from byte %1 on.").arg(error.got);
        case ImageFault::LooksLikeOther:
            return error.target == image::FlashTarget::Fpga
                       ? Words::tr("This is firmware for the microcontroller, not a bitstream: %1.")
                             .arg(describe(error.reason))
                       : Words::tr("This is a bitstream for the FPGA, not firmware: %1.")
                             .arg(describe(error.reason));
    }
    return Words::tr("The file cannot be used.");
}

QString whatToDo(ImageFault fault) {
    switch (fault) {
        case ImageFault::PastEnd:
        case ImageFault::LooksLikeOther:
            return Words::tr("Choose the other target, or the right file.");
        case ImageFault::TooLarge:
        case ImageFault::Empty:
            return Words::tr("Check that it is the right file.");
        default:
            return Words::tr("Build the file again, or fetch it again.");
    }
}

}  // namespace

Description describe(const image::ImageError& error) {
    return {whatIsWrong(error), whatToDo(error.fault), {}};
}

QString describe(image::FlashTarget target) {
    return target == image::FlashTarget::Fpga ? Words::tr("FPGA") : Words::tr("microcontroller");
}

QString describe(image::ImageFormat format) {
    switch (format) {
        case image::ImageFormat::IntelHex:
            return Words::tr("Intel HEX");
        case image::ImageFormat::Binary:
            return Words::tr("binary");
        case image::ImageFormat::XilinxBit:
            return Words::tr("Xilinx .bit");
    }
    return {};
}

QString describe(image::GuessReason reason) {
    switch (reason) {
        case image::GuessReason::BitHeader:
            return Words::tr("it has the header of a Xilinx .bit file");
        case image::GuessReason::SyncWord:
            return Words::tr("it begins with the word by which an FPGA finds its bitstream");
        case image::GuessReason::ResetVector:
            return Words::tr("it begins with the jump that starts a microcontroller");
        case image::GuessReason::Size:
            return Words::tr("it is larger than the microcontroller");
        case image::GuessReason::Form:
            return Words::tr("going by the format alone");
    }
    return {};
}

QString addressText(std::uint32_t address) {
    return QStringLiteral("0x%1").arg(address, 5, 16, QLatin1Char('0'));
}

}  // namespace kickstand
