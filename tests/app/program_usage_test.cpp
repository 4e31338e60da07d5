// What was typed wrong: exit 2, nothing on standard output, one line on standard error that names it and says
// what to do.

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

struct BadUsage {
    const char* name;
    std::vector<std::string> arguments;
    const char* said;  ///< A piece of the complaint.
};

class ProgramUsage : public testing::TestWithParam<BadUsage> {};

TEST_P(ProgramUsage, IsRefusedInOneLineWithExitTwo) {
    const Ended ended = run(GetParam().arguments);
    EXPECT_EQ(ended.exitCode, 2);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.err.find(GetParam().said), std::string::npos) << ended.err;
    EXPECT_EQ(ended.out, "");
}

TEST_P(ProgramUsage, GivesAScriptOneJsonValue) {
    std::vector<std::string> arguments = GetParam().arguments;
    arguments.insert(arguments.begin(), "--json");
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exitCode, 2);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_TRUE(ended.object().contains(QLatin1String("error"))) << ended.out;
}

const std::string kSim = "--link=sim:thunderbots?robots=0-3";

const BadUsage kCommandLines[] = {
    {"Nothing", {}, "No command"},
    {"UnknownCommand", {"thunderbots", "drvie"}, "Did you mean “thunderbots drive”?"},
    {"UnknownWord", {"fly"}, "no command “fly”"},
    {"GroupAlone", {"thunderbots"}, "thunderbots --help"},
    {"UnknownOption", {"devices", "--jsn"}, "Did you mean “--json”?"},
    {"ForeignOption", {"devices", "--robot", "3"}, "takes no “--robot”"},
    {"MissingValue", {kSim, "thunderbots", "drive", "--robot", "--wheels", "1,2,3,4"}, "needs a value"},
    {"ValueMissingAtTheEnd", {kSim, "thunderbots", "monitor", "--for"}, "needs a value"},
    {"GivenTwice", {kSim, "thunderbots", "monitor", "--for", "1", "--for", "2"}, "given twice"},
    {"ValueOnASwitch", {"--json=1", "devices"}, "takes no value"},
    {"TooMuch", {kSim, "thunderbots", "status", "now"}, "“now” is too much"},
    {"ControlCharacters", {"de\nvi\x1b[2Jces"}, "no command"},
};

const BadUsage kLinks[] = {
    {"NoLink", {"--link", "dongle", "thunderbots", "status"}, "is not a link"},
    {"EmptyLink", {"--link", "", "thunderbots", "status"}, "is not a link"},
    {"UnknownScheme",
     {"--link", "tcp:1.2.3.4", "thunderbots", "status"},
     "Accepted: usb:, usb-cable:, usbip:HOST:PORT/BUSID, serial:PATH?protocol=NAME, sim:thunderbots"},
    {"UnknownSystem", {"--link", "sim:nothing", "thunderbots", "status"}, "sim:thunderbots"},
    {"UnknownUsbOption", {"--link", "usb:?serial=3", "thunderbots", "status"}, "Accepted: port"},
    {"EmptyPort", {"--link", "usb:?port=", "thunderbots", "status"}, "Accepted: port"},
    {"UsbipWithoutBusId",
     {"--link", "usbip:127.0.0.1:3240", "thunderbots", "status"},
     "Accepted: usbip:HOST[:PORT]/BUSID"},
    {"UsbTarget", {"--link", "usb:1-2", "thunderbots", "status"}, "Accepted: usb:"},
    {"UnknownSimOption", {"--link", "sim:thunderbots?robts=3", "thunderbots", "status"}, "There is: robots"},
    {"SimValueOutOfRange", {"--link", "sim:thunderbots?loss=2", "thunderbots", "status"}, "from 0 to 1"},
    {"SimValueNoNumber",
     {"--link", "sim:thunderbots?robots=all", "thunderbots", "status"},
     "robots is not right: all"},
    {"BrokenEscape", {"--link", "sim:thunderbots?robots=%zz", "thunderbots", "status"}, "cannot be read"},
};

const BadUsage kNumbers[] = {
    {"NoRobot", {kSim, "thunderbots", "drive", "--wheels", "1,2,3,4", "--for", "1"}, "needs --robot"},
    {"NoWheels", {kSim, "thunderbots", "drive", "--robot", "3", "--for", "1"}, "needs --wheels"},
    {"NoTime", {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,2,3,4"}, "needs --for"},
    {"RobotSixteen",
     {kSim, "thunderbots", "drive", "--robot", "16", "--wheels", "1,2,3,4", "--for", "1"},
     "0 to 15"},
    {"RobotNegative",
     {kSim, "thunderbots", "drive", "--robot", "-1", "--wheels", "1,2,3,4", "--for", "1"},
     "0 to 15"},
    {"ThreeWheels",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,2,3", "--for", "1"},
     "four speeds"},
    {"WheelNoNumber",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,2,x,4", "--for", "1"},
     "Wheel 3"},
    {"WheelNeedsLimit",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "101,0,0,0", "--for", "1"},
     "needs --limit"},
    {"WheelPastLimit",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "301,0,0,0", "--for", "1", "--limit", "300"},
     "More than ±300"},
    {"WheelNeverLegal",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "-1024,0,0,0", "--for", "1", "--limit",
      "1023"},
     "-1023 to 1023"},
    {"LimitTooHigh",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,0,0,0", "--for", "1", "--limit", "1024"},
     "0 to 1023"},
    {"TimeZero", {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,0,0,0", "--for", "0"}, "0.01"},
    {"TimeNegative",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,0,0,0", "--for", "-1"},
     "--for"},
    {"TimeWithComma",
     {kSim, "thunderbots", "drive", "--robot", "3", "--wheels", "1,0,0,0", "--for", "0,5"},
     "--for"},
    {"TimeNotANumber", {kSim, "thunderbots", "monitor", "--for", "nan"}, "--for"},
    {"TimeInfinite", {kSim, "thunderbots", "monitor", "--for", "inf"}, "--for"},
    {"KickWithoutWidth", {kSim, "thunderbots", "kick", "--robot", "3"}, "needs --width1"},
    {"KickForTwoRobots",
     {kSim, "thunderbots", "kick", "--robot", "1,2", "--width1", "2000"},
     "--robot cannot be"},
    {"KickTooLong", {kSim, "thunderbots", "kick", "--robot", "3", "--width1", "4100"}, "4064"},
    {"KickEdgeTooLate",
     {kSim, "thunderbots", "kick", "--robot", "3", "--width1", "100", "--width2", "2000", "--offset", "2100"},
     "solenoid 2"},
    {"KickEmpty", {kSim, "thunderbots", "kick", "--robot", "3", "--width1", "0"}, "without any pulse"},
    {"KickNegative", {kSim, "thunderbots", "kick", "--robot", "3", "--width1", "-5"}, "--width1"},
    {"AutokickWithoutTime",
     {kSim, "thunderbots", "autokick", "--robot", "3", "--width1", "2000"},
     "needs --for"},
    {"AutokickEmpty",
     {kSim, "thunderbots", "autokick", "--robot", "3", "--width1", "0", "--for", "1"},
     "without any pulse"},
    {"ChargeWithoutTime", {kSim, "thunderbots", "charge", "--robot", "3"}, "needs --for"},
    {"ChargeTooFar",
     {kSim, "thunderbots", "charge", "--robot", "3", "--for", "1", "--until", "400"},
     "--until"},
    {"DischargeWithoutRobot", {kSim, "thunderbots", "discharge"}, "needs --robot"},
    {"UnknownClass", {kSim, "thunderbots", "test-mode", "--robot", "3", "--class", "disco"}, "lamp, hall"},
    {"TargetMissing",
     {kSim, "thunderbots", "test-mode", "--robot", "3", "--class", "hall"},
     "needs --target"},
    {"TargetTooHigh",
     {kSim, "thunderbots", "test-mode", "--robot", "3", "--class", "encoder", "--target", "5"},
     "1 to 4"},
    {"TargetForNothing",
     {kSim, "thunderbots", "test-mode", "--robot", "3", "--class", "lamp", "--target", "1"},
     "no targets"},
    {"OneChannel", {kSim, "thunderbots", "channels", "0x0E"}, "radio 1 is missing"},
    {"ChannelTooLow", {kSim, "thunderbots", "channels", "10", "11"}, "11 to 26"},
    {"ChannelTooHigh", {kSim, "thunderbots", "channels", "0x0E", "0x1B"}, "11 to 26"},
    {"ChannelHuge", {kSim, "thunderbots", "channels", "99999999999999999999", "11"}, "11 to 26"},
};

const BadUsage kMessages[] = {
    {"DecodeNothing", {"decode"}, "needs MESSAGE HEX"},
    {"DecodeNoBytes", {"decode", "thunderbots.drive"}, "needs MESSAGE HEX"},
    {"DecodeUnknown", {"decode", "thunderbots.drvie", "80"}, "Did you mean “thunderbots.drive”?"},
    {"DecodeNoHex", {"decode", "thunderbots.drive", "xyz"}, "is not hex"},
    {"DecodeHalfAByte", {"decode", "thunderbots.drive", "8"}, "is not hex"},
    {"DecodeEmptyBytes", {"decode", "thunderbots.drive", ""}, "length"},
    {"DecodeShort", {"decode", "thunderbots.drive", "80 00"}, "10"},
    {"DecodeLong", {"decode", "thunderbots.kick", "00 00 00 00"}, "length"},
    {"DecodeIllegalWheel", {"decode", "thunderbots.drive", "80 80 00 00 00 00 00 00 00 00"}, "wheel1"},
    {"EncodeNothing", {"encode"}, "needs MESSAGE"},
    {"EncodeUnknown", {"encode", "thunderbots.kik"}, "Did you mean “thunderbots.kick”?"},
    {"EncodeNoField", {"encode", "thunderbots.drive", "wheel1"}, "FIELD=VALUE"},
    {"EncodeUnknownField", {"encode", "thunderbots.drive", "wheel5=1"}, "wheel4"},
    {"EncodeOutOfRange", {"encode", "thunderbots.drive", "wheel1=-1024"}, "-1023 to 1023"},
    {"EncodeNoNumber", {"encode", "thunderbots.drive", "wheel1=fast"}, "fast"},
    {"EncodeTwice", {"encode", "thunderbots.drive", "run=1", "run=0"}, "given twice"},
};

const auto kNameOf = [](const testing::TestParamInfo<BadUsage>& info) {
    return std::string(info.param.name);
};
INSTANTIATE_TEST_SUITE_P(CommandLines, ProgramUsage, testing::ValuesIn(kCommandLines), kNameOf);
INSTANTIATE_TEST_SUITE_P(Links, ProgramUsage, testing::ValuesIn(kLinks), kNameOf);
INSTANTIATE_TEST_SUITE_P(Numbers, ProgramUsage, testing::ValuesIn(kNumbers), kNameOf);
INSTANTIATE_TEST_SUITE_P(Messages, ProgramUsage, testing::ValuesIn(kMessages), kNameOf);

}  // namespace
}  // namespace kickstand::test
