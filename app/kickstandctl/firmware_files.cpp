#include "app/kickstandctl/firmware_files.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <algorithm>

#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"
#include "core/engine/describe_images.h"
#include "core/thunderbots/image/image_file.h"

namespace kickstand::ctl {
namespace {

namespace image = thunderbots::image;

Expected<std::optional<image::FlashTarget>> readTarget(const Invocation& invocation) {
    if (!invocation.has("--target")) return std::nullopt;
    const std::string_view text = invocation.text("--target");
    if (text == "pic" || text == image::name(image::FlashTarget::Microcontroller))
        return image::FlashTarget::Microcontroller;
    if (text == image::name(image::FlashTarget::Fpga)) return image::FlashTarget::Fpga;
    return badUsage(Words::tr("--target is “%1”.").arg(printable(std::string(text))),
                    Words::tr("Give pic or fpga."));
}

tl::unexpected<Failure> refusedFile(const QString& name, const image::ImageError& error) {
    Failure failure;
    failure.exitCode = kBadUsage;
    failure.text = describe(error);
    failure.text.what = Words::tr("%1: %2").arg(name, failure.text.what);
    failure.code = QString::fromLatin1(image::name(error.fault));
    return tl::unexpected(std::move(failure));
}

Expected<FirmwareFile> readFile(const std::string& path, std::optional<image::FlashTarget> target) {
    FirmwareFile firmware;
    QFile file(QString::fromStdString(path));
    firmware.name = printable(QFileInfo(file).fileName().toStdString());
    if (!file.open(QIODevice::ReadOnly))
        return badUsage(Words::tr("“%1” cannot be read: %2.").arg(printable(path), file.errorString()),
                        Words::tr("Check the name of the file."));
    const QByteArray content = file.read(static_cast<qint64>(image::kLargestFile) + 1);
    const ByteView bytes(reinterpret_cast<const std::uint8_t*>(content.constData()),
                         static_cast<std::size_t>(content.size()));
    auto read = image::readImage(path, bytes);
    if (!read) return refusedFile(firmware.name, read.error());
    if (!target) {
        if (!read->guess.certain())
            return badUsage(
                Words::tr("What “%1” is for cannot be told for certain: probably %2, %3.")
                    .arg(firmware.name, describe(read->guess.target), describe(read->guess.reason)),
                Words::tr("Say it with --target pic or --target fpga."));
        firmware.guessed = read->guess.reason;
    }
    const image::FlashTarget wanted = target.value_or(read->guess.target);
    auto settled = image::forTarget(*std::move(read), wanted);
    if (!settled) return refusedFile(firmware.name, settled.error());
    firmware.plan = std::make_shared<const thunderbots::FlashPlan>(*std::move(settled));
    return firmware;
}

QString rangeText(const image::DataRange& range) {
    return Words::tr("%1 to %2").arg(addressText(range.begin), addressText(range.end - 1));
}

}  // namespace

std::uint16_t FirmwareFile::signature() const {
    const bool fpga = plan->target() == image::FlashTarget::Fpga;
    return fpga ? plan->signatures().flash : plan->signatures().microcontroller;
}

QString crcText(std::uint16_t signature) {
    return QStringLiteral("0x%1").arg(signature, 4, 16, QLatin1Char('0'));
}

Expected<std::vector<FirmwareFile>> readFirmwareFiles(const Invocation& invocation) {
    const auto target = readTarget(invocation);
    if (!target) return tl::unexpected(target.error());
    if (*target && invocation.operands.size() > 1)
        return badUsage(Words::tr("--target is about one file, and two were given."),
                        Words::tr("Leave it out: the files themselves show what they are for."));
    std::vector<FirmwareFile> files;
    for (const std::string& path : invocation.operands) {
        auto file = readFile(path, *target);
        if (!file) return tl::unexpected(file.error());
        files.push_back(*std::move(file));
    }
    std::ranges::sort(files, {}, [](const FirmwareFile& file) { return file.plan->target(); });
    if (files.size() == 2 && files[0].plan->target() == files[1].plan->target())
        return badUsage(
            Words::tr("Both files are for the same target: %1.").arg(describe(files[0].plan->target())),
            Words::tr("Give one file for the microcontroller and one for the FPGA."));
    return files;
}

QString firmwareText(const FirmwareFile& file) {
    const image::FlashImage& image = file.plan->image();
    QString text = Words::tr("%1: %2, %3, bytes of data: %4, pages to send: %5, signature %6")
                       .arg(file.name, describe(image.target), describe(image.format))
                       .arg(image.dataBytes())
                       .arg(file.plan->pages().size())
                       .arg(crcText(file.signature()));
    if (file.guessed) text += Words::tr("; for this target because %1").arg(describe(*file.guessed));
    if (!image.header.part.empty())
        text += Words::tr(", for %1, made %2 %3")
                    .arg(printable(image.header.part), printable(image.header.date),
                         printable(image.header.time));
    for (const image::DataRange& range : image.skipped)
        text += Words::tr("; left out: %1").arg(rangeText(range));
    return text;
}

QJsonObject firmwareToJson(const FirmwareFile& file) {
    const image::FlashImage& image = file.plan->image();
    QJsonArray skipped;
    for (const image::DataRange& range : image.skipped)
        skipped.append(QJsonObject{{QStringLiteral("begin"), static_cast<qint64>(range.begin)},
                                   {QStringLiteral("end"), static_cast<qint64>(range.end)}});
    return {{QStringLiteral("file"), file.name},
            {QStringLiteral("target"), QString::fromLatin1(image::name(image.target))},
            {QStringLiteral("guessed_from"),
             file.guessed ? QString::fromLatin1(image::name(*file.guessed)) : QString()},
            {QStringLiteral("format"), QString::fromLatin1(image::name(image.format))},
            {QStringLiteral("data_B"), static_cast<qint64>(image.dataBytes())},
            {QStringLiteral("pages"), static_cast<qint64>(file.plan->pages().size())},
            {QStringLiteral("signature"), file.signature()},
            {QStringLiteral("part"), printable(image.header.part)},
            {QStringLiteral("skipped"), skipped}};
}

}  // namespace kickstand::ctl
