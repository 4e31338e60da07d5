#include "core/engine/describe_error_texts.h"

#include <QtGlobal>
#include <array>

namespace kickstand {
namespace {

// The rule that packaging/udev/60-kickstand.rules installs, as one command that works without this source
// tree.
constexpr char kInstallUdevRule[] =
    "echo 'SUBSYSTEM==\"usb\", ATTR{idVendor}==\"04d8\", ATTR{idProduct}==\"7839|783a\", MODE=\"0660\", "
    "GROUP=\"plugdev\", TAG+=\"uaccess\"' | sudo tee /etc/udev/rules.d/60-kickstand.rules && "
    "sudo udevadm control --reload && sudo udevadm trigger --subsystem-match=usb";

// Who may open serial ports, on Debian and its kin.
constexpr char kJoinDialout[] = "sudo usermod --append --groups dialout \"$USER\"";

// What was asked for makes no sense, or the bytes do not.
constexpr ErrorText kInput[] = {
    {Errc::BadArgument, QT_TRANSLATE_NOOP("Error", "{subject} is not right: {detail}."),
     QT_TRANSLATE_NOOP("Error", "Check what was entered.")},
    {Errc::BadArgument, QT_TRANSLATE_NOOP("Error", "{subject}[ of robot {robot}] is not right."),
     QT_TRANSLATE_NOOP("Error", "Check what was entered.")},
    {Errc::BadArgument, QT_TRANSLATE_NOOP("Error", "What was asked for makes no sense[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Check what was entered.")},

    {Errc::OutOfRange, QT_TRANSLATE_NOOP("Error", "{subject}[ of robot {robot}] is {got}."),
     QT_TRANSLATE_NOOP("Error", "Choose a value from {lowest} to {highest}.")},
    {Errc::OutOfRange,
     QT_TRANSLATE_NOOP("Error", "{subject}[ of robot {robot}] is out of range[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Choose a value from {lowest} to {highest}.")},
    {Errc::OutOfRange, QT_TRANSLATE_NOOP("Error", "{subject} is out of range: {detail}."),
     QT_TRANSLATE_NOOP("Error", "Choose a value within its range.")},
    {Errc::OutOfRange, QT_TRANSLATE_NOOP("Error", "A value is out of range[: {got}]."),
     QT_TRANSLATE_NOOP("Error", "Choose one within its range[: {lowest} to {highest}].")},

    {Errc::UnknownName, QT_TRANSLATE_NOOP("Error", "There is no “{subject}” here."),
     QT_TRANSLATE_NOOP("Error", "There is: {detail}.")},
    {Errc::UnknownName, QT_TRANSLATE_NOOP("Error", "That name is not known here[: {subject}]."),
     QT_TRANSLATE_NOOP("Error", "Check its spelling.")},

    {Errc::BadUri,
     QT_TRANSLATE_NOOP("Error",
                       "“{subject}” is not a link: “{detail}”, from character {place} on, cannot be read."),
     QT_TRANSLATE_NOOP("Error", "A link looks like usb:, usb:?port=1-2.3 or sim:thunderbots.")},
    {Errc::BadUri, QT_TRANSLATE_NOOP("Error", "“{subject}” is not a link that can be opened here."),
     QT_TRANSLATE_NOOP("Error", "Accepted: {detail}.")},
    {Errc::BadUri, QT_TRANSLATE_NOOP("Error", "That is not a link that can be opened here[: {subject}]."),
     QT_TRANSLATE_NOOP("Error", "A link looks like usb:, usb:?port=1-2.3 or sim:thunderbots.")},

    {Errc::Unsupported, QT_TRANSLATE_NOOP("Error", "“{subject}” is not possible here[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "The help says what is.")},
    {Errc::Unsupported, QT_TRANSLATE_NOOP("Error", "That is not possible here[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "The help says what is.")},

    {Errc::NoEncoding,
     QT_TRANSLATE_NOOP(
         "Error",
         "The pulse of {subject} would end after {got} µs, and {highest} µs is the latest there is."),
     QT_TRANSLATE_NOOP("Error", "Shorten the pulse or the offset.")},
    {Errc::NoEncoding,
     QT_TRANSLATE_NOOP("Error", "A kick[ of robot {robot}] without any pulse does not exist."),
     QT_TRANSLATE_NOOP("Error", "Give at least one of the two pulses a width.")},

    {Errc::Malformed, QT_TRANSLATE_NOOP("Error", "{subject} is {got}, which cannot be."),
     QT_TRANSLATE_NOOP("Error", "It has to be {lowest} to {highest}.")},
    {Errc::Malformed, QT_TRANSLATE_NOOP("Error", "“{detail}”, from character {place} on, is not {subject}."),
     QT_TRANSLATE_NOOP("Error", "Check what was entered.")},
    {Errc::Malformed, QT_TRANSLATE_NOOP("Error", "{subject} cannot be read[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Check where it comes from.")},
    {Errc::Malformed,
     QT_TRANSLATE_NOOP("Error", "Bytes came that cannot be read[ (endpoint {endpoint})][: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Check that the device is what it says it is.")},
};

// Links and devices.
constexpr ErrorText kDevices[] = {
    {Errc::NoDevice, QT_TRANSLATE_NOOP("Error", "There is no serial port {port}."),
     QT_TRANSLATE_NOOP("Error", "Plug the device in, or check the port's name.")},
    {Errc::NoDevice, QT_TRANSLATE_NOOP("Error", "There is no device at {subject}: {detail}."),
     QT_TRANSLATE_NOOP(
         "Error",
         "See that it is plugged in there and that its server runs (kickstand-sim, or usbipd on that "
         "machine), or check the address.")},
    {Errc::NoDevice, QT_TRANSLATE_NOOP("Error", "No dongle or cabled robot is plugged in[ ({subject})]."),
     QT_TRANSLATE_NOOP("Error", "Plug one in, or try a simulated one: sim:thunderbots.")},
    {Errc::SeveralDevices,
     QT_TRANSLATE_NOOP("Error",
                       "Several devices are plugged in, and any of them could be meant[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Name one by its place on the bus, as in usb:?port=1-2.3.")},
    {Errc::PermissionDenied, QT_TRANSLATE_NOOP("Error", "This user may not open the serial port {port}."),
     QT_TRANSLATE_NOOP("Error", "Join the group that may, then log in again:"), kJoinDialout},
    {Errc::PermissionDenied,
     QT_TRANSLATE_NOOP("Error", "The dongle is there[ ({subject})], but this user may not open it."),
     QT_TRANSLATE_NOOP("Error", "Install the udev rule:"), kInstallUdevRule},
    {Errc::ClaimedElsewhere, QT_TRANSLATE_NOOP("Error", "Another program holds the serial port {port}."),
     QT_TRANSLATE_NOOP("Error", "Close that program: a serial monitor, an IDE, or another bench.")},
    {Errc::ClaimedElsewhere,
     QT_TRANSLATE_NOOP("Error", "The device at {subject} is in use: {detail} (USB/IP status {got})."),
     QT_TRANSLATE_NOOP("Error", "Close the program that has it, here or on another machine.")},
    {Errc::ClaimedElsewhere,
     QT_TRANSLATE_NOOP("Error",
                       "The dongle is there[ ({subject})], but another program holds it[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Close that program; `kickstandctl doctor` says which one it is.")},
    {Errc::Disconnected, QT_TRANSLATE_NOOP("Error", "The serial port {port} is gone."),
     QT_TRANSLATE_NOOP("Error", "Plug the device in again.")},
    {Errc::Disconnected,
     QT_TRANSLATE_NOOP("Error", "The device is gone: unplugged, or without power[ ({subject})]."),
     QT_TRANSLATE_NOOP("Error", "Plug it in again.")},
    {Errc::Stalled,
     QT_TRANSLATE_NOOP("Error", "The device keeps refusing[ {subject}][ on endpoint {endpoint}]."),
     QT_TRANSLATE_NOOP(
         "Error",
         "Unplug it and plug it in again; if that does not help, its firmware is not what is expected.")},
    {Errc::TimedOut, QT_TRANSLATE_NOOP("Error", "No answer came in time from robot {robot}[ ({subject})]."),
     QT_TRANSLATE_NOOP("Error", "Check that it is switched on and near, then try again.")},
    {Errc::TimedOut, QT_TRANSLATE_NOOP("Error", "No answer came in time[: {subject}]."),
     QT_TRANSLATE_NOOP("Error", "Try again; if it stays so, unplug the device and plug it in again.")},
    {Errc::Cancelled, QT_TRANSLATE_NOOP("Error", "It was broken off before it was done[ ({subject})]."),
     QT_TRANSLATE_NOOP("Error", "Start it again if it is still wanted.")},
    {Errc::Io, QT_TRANSLATE_NOOP("Error", "The serial port {port} does not work[: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Unplug the device and plug it in again.")},
    {Errc::Io,
     QT_TRANSLATE_NOOP("Error", "The operating system reports a failure[ of {subject}][: {detail}]."),
     QT_TRANSLATE_NOOP("Error",
                       "Unplug the device and plug it in again, into another socket if there is one.")},
    {Errc::RadioFailed, QT_TRANSLATE_NOOP("Error", "Radio {got} of the dongle does not start."),
     QT_TRANSLATE_NOOP(
         "Error",
         "Unplug the dongle and plug it in again; if it stays so, look at that radio module's seat.")},
    {Errc::RadioFailed,
     QT_TRANSLATE_NOOP("Error", "The dongle's radios do not start[: {subject}][: {detail}]."),
     QT_TRANSLATE_NOOP(
         "Error",
         "Unplug the dongle and plug it in again; if it stays so, look at the radio modules' seats.")},
    {Errc::ChannelsLocked,
     QT_TRANSLATE_NOOP("Error", "The dongle does not change its channels while its radios run."),
     QT_TRANSLATE_NOOP("Error", "Disconnect, connect again, and set them then.")},
};

// Refusals that keep people safe, and back-pressure.
constexpr ErrorText kRefusals[] = {
    {Errc::NotConnected, QT_TRANSLATE_NOOP("Error", "No link is running."),
     QT_TRANSLATE_NOOP("Error", "Connect first.")},
    {Errc::StopLatched, QT_TRANSLATE_NOOP("Error", "Everything is stopped."),
     QT_TRANSLATE_NOOP("Error", "Re-arm first.")},
    {Errc::NotArmed, QT_TRANSLATE_NOOP("Error", "The high voltage of robot {robot} is not armed."),
     QT_TRANSLATE_NOOP("Error", "Arm it first.")},
    {Errc::NotArmed, QT_TRANSLATE_NOOP("Error", "The high voltage is not armed."),
     QT_TRANSLATE_NOOP("Error", "Arm it first.")},
    {Errc::RobotNotAlive, QT_TRANSLATE_NOOP("Error", "TOWRP {got} is not heard."),
     QT_TRANSLATE_NOOP("Error",
                       "Switch it on, and check that both radio modules have the same channel and network.")},
    {Errc::RobotNotAlive, QT_TRANSLATE_NOOP("Error", "Robot {robot} is not heard."),
     QT_TRANSLATE_NOOP("Error", "Switch it on, and check its number, its channels and its battery.")},
    {Errc::RobotNotAlive, QT_TRANSLATE_NOOP("Error", "The robot is not heard."),
     QT_TRANSLATE_NOOP("Error", "Switch it on, and check its number, its channels and its battery.")},
    {Errc::EmergencyStopNotRun, QT_TRANSLATE_NOOP("Error", "The emergency stop is not at “run”."),
     QT_TRANSLATE_NOOP("Error", "Check that its switch is plugged into the dongle, and turn it to “run”.")},
    {Errc::KickOutstanding,
     QT_TRANSLATE_NOOP("Error", "The kick before[ for robot {robot}] has not been given to the dongle yet."),
     QT_TRANSLATE_NOOP("Error", "Wait a moment, then kick again.")},
    {Errc::KickExpired,
     QT_TRANSLATE_NOOP("Error",
                       "The kick[ for robot {robot}] was dropped: the dongle did not take it within 200 ms."),
     QT_TRANSLATE_NOOP("Error", "Kick again; if it happens often, the radio is overloaded or disturbed.")},
    {Errc::MustPassZero,
     QT_TRANSLATE_NOOP("Error", "This input has been held since before[ robot {robot} could be driven]."),
     QT_TRANSLATE_NOOP("Error", "Let it go back to zero once.")},
    {Errc::NotDischarging, QT_TRANSLATE_NOOP("Error", "The capacitor[ of robot {robot}] does not empty."),
     QT_TRANSLATE_NOOP("Error", "Treat it as live, switch the robot off and let it stand.")},
    {Errc::ReadingsUnknown,
     QT_TRANSLATE_NOOP("Error", "Robot {robot} has not sent its readings, so its voltage is not known."),
     QT_TRANSLATE_NOOP("Error", "Treat it as live, and wait until it reports.")},
    {Errc::ReadingsUnknown,
     QT_TRANSLATE_NOOP("Error", "The robot has not sent its readings, so its voltage is not known."),
     QT_TRANSLATE_NOOP("Error", "Treat it as live, and wait until it reports.")},
    {Errc::CheckRunning, QT_TRANSLATE_NOOP("Error", "A check[ of robot {robot}] is running."),
     QT_TRANSLATE_NOOP("Error", "Wait for its end, or stop it.")},
    {Errc::SweepRunning, QT_TRANSLATE_NOOP("Error", "A sweep[ of robot {robot}] is running."),
     QT_TRANSLATE_NOOP("Error", "Wait for its end, or stop it.")},
    {Errc::NotCharging, QT_TRANSLATE_NOOP("Error", "The capacitor[ of robot {robot}] was not full in time."),
     QT_TRANSLATE_NOOP("Error", "Check the charger and the battery, or give it longer.")},
    {Errc::QueueFull, QT_TRANSLATE_NOOP("Error", "Too much is waiting already[ ({subject})]."),
     QT_TRANSLATE_NOOP("Error", "Wait a moment, then try again.")},
    {Errc::HeartbeatStale,
     QT_TRANSLATE_NOOP("Error", "The program was too busy to watch over the robots, so they were braked."),
     QT_TRANSLATE_NOOP("Error", "Re-arm, and close what keeps the computer busy.")},
};

// Smart devices.
constexpr ErrorText kSmartDevices[] = {
    {Errc::DeviceRefused, QT_TRANSLATE_NOOP("Error", "{detail} did not take {subject}."),
     QT_TRANSLATE_NOOP("Error", "Check the value, and whether the board is disabled or out of order.")},
    {Errc::DeviceRefused, QT_TRANSLATE_NOOP("Error", "The device did not take it[: {subject}]."),
     QT_TRANSLATE_NOOP("Error", "Check the value, and whether the board is disabled or out of order.")},
};

// Firmware: requests to robots, and uploads.
constexpr ErrorText kFirmware[] = {
    {Errc::RequestPending,
     QT_TRANSLATE_NOOP("Error", "Robot {robot} is still busy with what it was asked before."),
     QT_TRANSLATE_NOOP("Error", "Wait until it has answered.")},
    {Errc::RequestPending,
     QT_TRANSLATE_NOOP("Error", "The robot is still busy with what it was asked before."),
     QT_TRANSLATE_NOOP("Error", "Wait until it has answered.")},
    {Errc::Unanswered,
     QT_TRANSLATE_NOOP("Error",
                       "The robot[ {robot}] answers, but not to this[: {subject}][, asked {got} times]."),
     QT_TRANSLATE_NOOP("Error", "Try again; if it stays so, its firmware does not know this request.")},
    {Errc::NotBraked, QT_TRANSLATE_NOOP("Error", "The robot[ {robot}] is not at rest[: {subject} is on]."),
     QT_TRANSLATE_NOOP("Error", "Brake it, and switch its dribbler, charger and autokick off.")},
    {Errc::CapacitorLive,
     QT_TRANSLATE_NOOP("Error",
                       "The capacitor[ of robot {robot}] is at {got} V[, and has to be below {highest} V]."),
     QT_TRANSLATE_NOOP("Error", "Discharge it first.")},
    {Errc::CapacitorLive, QT_TRANSLATE_NOOP("Error", "The capacitor[ of robot {robot}] is charged."),
     QT_TRANSLATE_NOOP("Error", "Discharge it first.")},
    {Errc::BatteryLow,
     QT_TRANSLATE_NOOP(
         "Error", "The battery[ of robot {robot}] is at {got} V, too low to be sure of reaching the end."),
     QT_TRANSLATE_NOOP("Error", "Charge or change it; or allow a low battery if it cannot be helped.")},
    {Errc::BatteryLow, QT_TRANSLATE_NOOP("Error", "The battery[ of robot {robot}] is low."),
     QT_TRANSLATE_NOOP("Error", "Charge or change it; or allow a low battery if it cannot be helped.")},
    {Errc::NotCommitted,
     QT_TRANSLATE_NOOP("Error", "The robot[ {robot}] has parameters that were applied and not committed."),
     QT_TRANSLATE_NOOP("Error", "Commit them, or reboot the robot to give them up.")},
    {Errc::RebootNeeded,
     QT_TRANSLATE_NOOP(
         "Error",
         "The robot[ {robot}] has a number or channels that it does not use before its next reboot."),
     QT_TRANSLATE_NOOP("Error", "Reboot it first.")},
    {Errc::ParametersUnread,
     QT_TRANSLATE_NOOP("Error", "The parameters[ of robot {robot}] have not been read yet."),
     QT_TRANSLATE_NOOP("Error", "Read them first.")},
    {Errc::FlashRunning, QT_TRANSLATE_NOOP("Error", "Firmware is being sent to the robot[ {robot}]."),
     QT_TRANSLATE_NOOP("Error", "Wait for the end of the upload, or cancel it.")},
    {Errc::FlashNotRunning, QT_TRANSLATE_NOOP("Error", "No firmware is being sent to the robot[ {robot}]."),
     QT_TRANSLATE_NOOP("Error", "Start the upload first.")},
    {Errc::AlreadyThere, QT_TRANSLATE_NOOP("Error", "The robot[ {robot}] has exactly this firmware already."),
     QT_TRANSLATE_NOOP("Error", "Nothing needs to be done; force it to send it all the same.")},
    {Errc::NotVerified,
     QT_TRANSLATE_NOOP(
         "Error", "What the robot[ {robot}] has in its flash is not what was sent[, from address {got} on]."),
     QT_TRANSLATE_NOOP("Error",
                       "Start the upload again; if it stays so, the flash memory is worn or broken.")},
    {Errc::WrongSignature,
     QT_TRANSLATE_NOOP("Error",
                       "The robot[ {robot}] runs, but its signature is {got} where {highest} was expected."),
     QT_TRANSLATE_NOOP("Error", "Start the upload again.")},
    {Errc::WrongSignature,
     QT_TRANSLATE_NOOP("Error", "The robot[ {robot}] runs, but not with the firmware that was sent."),
     QT_TRANSLATE_NOOP("Error", "Start the upload again.")},
};

// Motion plans.
constexpr ErrorText kPlans[] = {
    {Errc::NoMovementCode,
     QT_TRANSLATE_NOOP("Error", "Step {place}, “{subject}”, has no code that the robot knows."),
     QT_TRANSLATE_NOOP("Error", "Write in its place: {detail}.")},
    {Errc::NoMovementCode, QT_TRANSLATE_NOOP("Error", "The movement[ “{subject}”] has no code."),
     QT_TRANSLATE_NOOP("Error", "Choose a distance or an angle from the tables.")},
    {Errc::PlanRefused, QT_TRANSLATE_NOOP("Error", "The robot refused: {detail} (error {got})."),
     QT_TRANSLATE_NOOP("Error", "Execute a plan first, and adjust it before it ends."), "", "adjust-idle"},
    {Errc::PlanRefused, QT_TRANSLATE_NOOP("Error", "The robot refused: {detail} (error {got})."),
     QT_TRANSLATE_NOOP("Error", "Nothing needs to be stopped."), "", "stop-idle"},
    {Errc::PlanRefused, QT_TRANSLATE_NOOP("Error", "The robot refused: {detail} (error {got})."),
     QT_TRANSLATE_NOOP("Error", "Its program takes updates only while a plan executes: execute one first."),
     "", "update-idle"},
    {Errc::PlanRefused, QT_TRANSLATE_NOOP("Error", "The robot refused: {detail} (error {got})."),
     QT_TRANSLATE_NOOP("Error", "Query the slot to see what is in it, then try again.")},
    {Errc::PlanRefused, QT_TRANSLATE_NOOP("Error", "The robot refused."),
     QT_TRANSLATE_NOOP("Error", "Query the slot to see what is in it, then try again.")},
    {Errc::WouldBeRefused,
     QT_TRANSLATE_NOOP("Error", "Not sent, because the robot would refuse it: {detail} (error {got})."),
     QT_TRANSLATE_NOOP("Error", "Execute a plan first, and adjust it before it ends."), "", "adjust-idle"},
    {Errc::WouldBeRefused,
     QT_TRANSLATE_NOOP("Error", "Not sent, because the robot would refuse it: {detail} (error {got})."),
     QT_TRANSLATE_NOOP("Error",
                       "Choose an empty slot to create, or the ID of the plan in it to update or execute.")},
    {Errc::WouldBeRefused, QT_TRANSLATE_NOOP("Error", "Not sent, because the robot would refuse it."),
     QT_TRANSLATE_NOOP("Error", "Query the slot to see what is in it.")},
    {Errc::PlanExecuting, QT_TRANSLATE_NOOP("Error", "A plan is executing already, or may be."),
     QT_TRANSLATE_NOOP("Error", "Stop it first.")},
    {Errc::EchoDiffers,
     QT_TRANSLATE_NOOP("Error",
                       "The robot confirmed something else than was sent[ ({subject})][: {detail}]."),
     QT_TRANSLATE_NOOP("Error",
                       "Look at the robot: if it stands, stop the plan to be sure, and execute it again."),
     "", "execute"},
    {Errc::EchoDiffers,
     QT_TRANSLATE_NOOP("Error",
                       "The robot confirmed something else than was sent[ ({subject})][: {detail}]."),
     QT_TRANSLATE_NOOP("Error", "Look at the robot: if it does not do it, ask again."), "", "adjust"},
    {Errc::EchoDiffers,
     QT_TRANSLATE_NOOP("Error",
                       "The robot confirmed something else than was sent[ ({subject})][: {detail}]."),
     QT_TRANSLATE_NOOP("Error",
                       "Send it again; if what is missing begins at a zero byte, the robot's program reads "
                       "its mailbox as text.")},
    {Errc::Unconfirmed,
     QT_TRANSLATE_NOOP("Error",
                       "Nothing came back that says whether it arrived ({subject}), and it is not sent again "
                       "unasked."),
     QT_TRANSLATE_NOOP("Error",
                       "Look at the robot: if it stands, stop the plan to be sure, and execute it again."),
     "", "execute"},
    {Errc::Unconfirmed,
     QT_TRANSLATE_NOOP("Error",
                       "Nothing came back that says whether it arrived ({subject}), and it is not sent again "
                       "unasked."),
     QT_TRANSLATE_NOOP("Error", "Look at the robot: if it does not do it, ask again."), "", "adjust"},
    {Errc::Unconfirmed,
     QT_TRANSLATE_NOOP("Error",
                       "It arrived, and nothing came back that says whether the robot obeys (adjust); it is "
                       "not sent again unasked."),
     QT_TRANSLATE_NOOP("Error", "Look at the robot: if it does not do it, ask again."), "", "adjust-arrived"},
    {Errc::Unconfirmed,
     QT_TRANSLATE_NOOP("Error",
                       "The robot has not confirmed that it stands, though it was told several times."),
     QT_TRANSLATE_NOOP("Error", "Look at the robot: if it moves, stop it by hand."), "", "stop"},
    {Errc::Unconfirmed,
     QT_TRANSLATE_NOOP("Error",
                       "Nothing came back that says whether it arrived[ ({subject})], though it was sent "
                       "several times."),
     QT_TRANSLATE_NOOP("Error", "Ask what is there now, then send it again.")},
    {Errc::NxtRefused, QT_TRANSLATE_NOOP("Error", "The NXT answers that {detail} (status {got})."),
     QT_TRANSLATE_NOOP("Error", "Start the robot's program on it, then try again.")},
    {Errc::NxtRefused, QT_TRANSLATE_NOOP("Error", "The NXT refuses to answer."),
     QT_TRANSLATE_NOOP("Error", "Start the robot's program on it, then try again.")},
};

// COACH and TOWRP.
constexpr ErrorText kCoach[] = {
    {Errc::NotPaired, QT_TRANSLATE_NOOP("Error", "No boat and COACH are paired."),
     QT_TRANSLATE_NOOP("Error", "Pair them first.")},
    {Errc::PairedElsewhere,
     QT_TRANSLATE_NOOP("Error", "The boat[ of team {robot}] obeys another COACH[: that of team {got}]."),
     QT_TRANSLATE_NOOP("Error", "Wait until it says that it is available again.")},
    {Errc::RoleRunning, QT_TRANSLATE_NOOP("Error", "This program plays a COACH or a TOWRP at present."),
     QT_TRANSLATE_NOOP("Error", "End that role first.")},
    {Errc::RadioNotReady, QT_TRANSLATE_NOOP("Error", "No radio module in API mode answers."),
     QT_TRANSLATE_NOOP("Error",
                       "Look for it and set it up: with `kickstandctl coach "
                       "radio set`.")},
    {Errc::RadioNotSet,
     QT_TRANSLATE_NOOP("Error", "The radio module is not set up[ for {subject}][: its address is {detail}]."),
     QT_TRANSLATE_NOOP("Error",
                       "Apply the preset for it: with `kickstandctl coach "
                       "radio set`.")},
    {Errc::RadioDiffers,
     QT_TRANSLATE_NOOP("Error", "The radio module says something else than what it was set to."),
     QT_TRANSLATE_NOOP("Error", "Read it again, and set what is still wrong.")},
};

template <std::size_t... Sizes>
constexpr auto joined(const ErrorText (&... groups)[Sizes]) {
    std::array<ErrorText, (Sizes + ...)> all{};
    std::size_t at = 0;
    const auto append = [&](std::span<const ErrorText> group) {
        for (const ErrorText& text : group)
            all[at++] = text;
    };
    (append(groups), ...);
    return all;
}
constexpr auto kAll = joined(kInput, kDevices, kRefusals, kFirmware, kPlans, kCoach, kSmartDevices);

}  // namespace

std::span<const ErrorText> errorTexts() {
    return kAll;
}

}  // namespace kickstand
