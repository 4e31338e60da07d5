#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/parameters.h"

namespace kickstand::thunderbots {

/// The fields of an operational parameters block that have a meaning (protocol 4.8). What a robot has behind
/// them is never edited.
enum class ParameterField : std::uint8_t { FlashContents, Channel0, Channel1, RobotNumber, DribblerDuty };

inline constexpr std::array kParameterFields{ParameterField::FlashContents, ParameterField::Channel0,
                                             ParameterField::Channel1, ParameterField::RobotNumber,
                                             ParameterField::DribblerDuty};
inline constexpr std::size_t kParameterFieldCount = kParameterFields.size();

/// A choice of fields: bit n is the field whose number is n.
using ParameterMask = std::uint8_t;
constexpr ParameterMask maskOf(ParameterField field) {
    return static_cast<ParameterMask>(1U << static_cast<unsigned>(field));
}
constexpr bool contains(ParameterMask mask, ParameterField field) {
    return (mask & maskOf(field)) != 0;
}
inline constexpr ParameterMask kAllParameters = (1U << kParameterFieldCount) - 1;
/// What can be set as one likes. The flash contents say what is there, and are not made true by being set.
inline constexpr ParameterMask kSettings =
    static_cast<ParameterMask>(kAllParameters & ~maskOf(ParameterField::FlashContents));

/// "flash_contents", "channel0", "channel1", "robot_number", "dribbler_duty": the names of the wire's own
/// tables. Any thread.
std::string_view name(ParameterField field);
/// The field of that name. Any thread.
std::optional<ParameterField> parameterFieldFromName(std::string_view name);

/// A field's value, as it stands in the block. Any thread.
std::uint8_t valueOf(const wire::OperationalParameters& parameters, ParameterField field);
/// Puts a value into a field, legal or not. Any thread.
void setValue(wire::OperationalParameters& parameters, ParameterField field, std::uint8_t value);

/// Whether a field may hold this. Errors: OutOfRange with the field's name and, where there are such, its
/// bounds. Any thread.
Result<void> checkParameter(ParameterField field, int value);

/// The value that a person wrote: a number (decimal, or hex with 0x), "none" for a channel, a duty as "47%",
/// and for the flash "fpga", "microcontroller" or "no-data". Errors: Malformed with what is accepted as its
/// detail; OutOfRange. Any thread.
Result<std::uint8_t> parseParameter(ParameterField field, std::string_view text);

/// "fpga", "microcontroller", "no-data": as parseParameter() takes them. Any thread.
std::string_view name(wire::FlashContents contents);
/// Percent of the full duty cycle, and the nearest duty to a percentage (0-100). Any thread.
constexpr double dutyPercent(int duty) {
    return duty * 100.0 / 255.0;
}
inline std::uint8_t dutyOfPercent(double percent) {
    return static_cast<std::uint8_t>(std::lround(percent * 255.0 / 100.0));
}

/// The fields in which two blocks differ. Any thread.
ParameterMask differences(const wire::OperationalParameters& a, const wire::OperationalParameters& b);

/// What goes wrong with a block from the robot's next boot on, once the block has been committed: numbers,
/// channels and flash contents mean nothing before (protocol 4.8, 6.8).
enum class ParameterRisk : std::uint8_t {
    NoChannel,       ///< A radio without a channel: no dongle hears the robot.
    OtherChannels,   ///< Not the channels of this dongle: it loses the robot.
    NumberTaken,     ///< Another robot that is alive has the number: both answer to it.
    NumberChanges,   ///< It answers to another number.
    CopiesFlash,     ///< It copies whatever is in its flash into its microcontroller.
    NoBitstream,     ///< Its FPGA gets no bitstream, so that it cannot drive.
    OtherBitstream,  ///< Its FPGA is given whatever is in the flash.
};

struct ParameterWarning {
    ParameterRisk risk = ParameterRisk::NumberChanges;
    int robot = 0;              ///< The number it answers to now.
    int nextNumber = 0;         ///< The number it will answer to.
    std::uint8_t channel0 = 0;  ///< Of the block.
    std::uint8_t channel1 = 0;

    /// Whether the robot would be lost, would disturb another one, or would change itself for good: what must
    /// not be done unasked.
    bool serious() const {
        return risk != ParameterRisk::NumberChanges && risk != ParameterRisk::NoBitstream;
    }
    friend bool operator==(const ParameterWarning&, const ParameterWarning&) = default;
};

/// What to say before robot `robot` is given `block`, gravest first. `channels`: the dongle's, none on a
/// cable, where no radio is at stake but the one that comes later. `alive`: the robots that are heard now.
/// `now`: the block that it has, where it is known; what a change would not make worse is not told. Any
/// thread.
std::vector<ParameterWarning> parameterWarnings(int robot, const wire::OperationalParameters& block,
                                                const std::optional<wire::OperationalParameters>& now,
                                                const std::optional<wire::Channels>& channels,
                                                RobotMask alive);

}  // namespace kickstand::thunderbots
