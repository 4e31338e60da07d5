#pragma once

#include <QJsonObject>
#include <optional>
#include <vector>

#include "app/kickstandctl/command.h"
#include "core/thunderbots/flash_plan.h"

namespace kickstand::ctl {

/// A firmware file that was read, checked and planned.
struct FirmwareFile {
    QString name;
    thunderbots::SharedFlashPlan plan;
    /// Why it is taken to be for this target; empty where a person said so.
    std::optional<thunderbots::image::GuessReason> guessed{};

    /// What its robot answers as signature once it has it.
    std::uint16_t signature() const;
};

/// Reads the operands of a command, and --target where that was given: one file, or one for each target in
/// the order in which they are sent.
Expected<std::vector<FirmwareFile>> readFirmwareFiles(const Invocation& invocation);

/// "main.hex: microcontroller, Intel HEX, 38400 bytes, 150 pages, signature 0x1a2b", and what was left out.
QString firmwareText(const FirmwareFile& file);
QJsonObject firmwareToJson(const FirmwareFile& file);
/// "0x1a2b".
QString crcText(std::uint16_t signature);

}  // namespace kickstand::ctl
