#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace kickstand {

/// A robot's operational parameters as they were read from it at one moment.
struct ParameterRecord {
    std::int64_t id = 0;                           ///< Given by the ledger; 0 before.
    std::chrono::system_clock::time_point time{};  ///< To the millisecond.
    std::string source;  ///< The link it was read through, as a URI: "usb:", "sim:thunderbots".
    int robot = 0;       ///< The number it answered to, 0-15; not its identity, since numbers can be changed.
    std::vector<std::uint8_t> block;  ///< As the robot sent it.
    /// The build signatures that it answered with, where they were read as well.
    std::optional<std::uint16_t> microcontrollerSignature;
    std::optional<std::uint16_t> flashSignature;
    std::string note;  ///< A person's own words, UTF-8.

    friend bool operator==(const ParameterRecord&, const ParameterRecord&) = default;
};

/// Build signatures of a robot, to go with the last record that was made of it.
struct SignatureRecord {
    std::string source;
    int robot = 0;
    std::uint16_t microcontroller = 0;
    std::uint16_t flash = 0;
};

/// What a ledger holds, and how it fares. Plain values; immutable where shared.
struct LedgerView {
    /// The newest records, newest first, Ledger::kMostShown at most; never null.
    std::shared_ptr<const std::vector<ParameterRecord>> records =
        std::make_shared<const std::vector<ParameterRecord>>();
    /// Why nothing can be kept at present; the file is its subject.
    std::optional<Error> error;
    std::uint64_t lost = 0;        ///< Records and notes that could not be kept.
    std::uint64_t unreadable = 0;  ///< Rows of the file that make no sense; left alone.
    std::uint64_t version = 0;     ///< Rises with every change of the above.
    bool opened = false;           ///< Whether the file has been looked at yet.
};

}  // namespace kickstand
