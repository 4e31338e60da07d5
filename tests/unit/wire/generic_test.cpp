#include "core/thunderbots/wire/generic.h"

#include <algorithm>
#include <string>

#include "core/thunderbots/wire/fields.h"
#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;
using Fields = std::vector<FieldText>;

const DecodedField& fieldOf(const std::vector<DecodedField>& fields, std::string_view name) {
    for (const DecodedField& field : fields) {
        if (field.name == name) return field;
    }
    ADD_FAILURE() << "no field " << name;
    return fields.front();
}

/// What was decoded, as it would be given to be encoded again.
Fields textOf(const std::vector<DecodedField>& decoded) {
    Fields fields;
    for (const DecodedField& field : decoded) {
        fields.emplace_back(field.name, field.isBytes ? toHex(field.bytes) : std::to_string(field.value));
    }
    return fields;
}

/// The error of what must not succeed.
template <class T>
Error errorOf(const Result<T>& result) {
    EXPECT_FALSE(result.has_value());
    return result ? Error{} : result.error();
}

void expectRefused(std::string_view message, const Fields& fields, Errc code, std::string_view subject) {
    const auto encoded = encodeMessage(message, fields);
    ASSERT_FALSE(encoded.has_value()) << message;
    EXPECT_STREQ(kickstand::name(encoded.error().code), kickstand::name(code));
    EXPECT_EQ(encoded.error().subject, subject);
}

TEST(EncodeMessage, WritesDriveFromItsFields) {
    const Fields fields{{"run", "true"}, {"charge", "1"}, {"mask1", "1"}, {"armed", "1"},
                        {"t1", "100"},   {"t2", "0x2f"},  {"dt", "9"}};
    EXPECT_EQ(encodeMessage("thunderbots.drive", fields).value(), hex("d4 00 00 00 00 00 00 32 2f 12"));
    EXPECT_EQ(encodeMessage("thunderbots.drive", Fields{{"run", "1"}, {"wheel1", "-1023"}}).value(),
              hex("80 80 20 00 00 00 00 00 00 00"));
    EXPECT_EQ(encodeMessage("thunderbots.drive", {}).value(), Bytes(10, 0));
}

TEST(EncodeMessage, TakesLabelsHexAndWritesOpcodesAndLengthsItself) {
    EXPECT_EQ(
        encodeMessage("thunderbots.test-mode", Fields{{"class", "encoder-count"}, {"target", "3"}}).value(),
        hex("04 03"));
    EXPECT_EQ(encodeMessage("thunderbots.status",
                            Fields{{"estop", "run"}, {"radios", "running"}, {"alive", "0x8001"}})
                  .value(),
              hex("03 03 01 80"));
    EXPECT_EQ(encodeMessage("thunderbots.firmware-request.fill-page",
                            Fields{{"offset", "64"}, {"data", "01 02 03"}})
                  .value(),
              hex("01 40 01 02 03"));
    EXPECT_EQ(encodeMessage("thunderbots.firmware-request.reboot", {}).value(), hex("08"));
    EXPECT_EQ(encodeMessage("thunderbots.autokick", {}).value(), Bytes{});
    EXPECT_EQ(
        encodeMessage("thunderbots.message", Fields{{"robot", "11"}, {"pipe", "2"}, {"payload", "cb8000"}})
            .value(),
        hex("b2 cb 80 00"));
}

TEST(EncodeMessage, TakesListsByNumber) {
    const std::string block = "80 00 00 00 00 00 00 00 00 00";
    EXPECT_EQ(
        encodeMessage("thunderbots.state-packet",
                      Fields{{"1.robot", "3"}, {"1.payload", block}, {"2.robot", "4"}, {"2.payload", block}})
            .value(),
        hex("0c 30 " + block + " 0c 40 " + block));
    EXPECT_EQ(encodeMessage("thunderbots.error-queue", Fields{{"code", "41"}}).value(), hex("29"));
    EXPECT_EQ(encodeMessage("thunderbots.state-packet", {}).value(), Bytes{});
    expectRefused("thunderbots.state-packet", {{"2.robot", "3"}, {"2.payload", block}}, Errc::BadArgument,
                  "thunderbots.state-packet 1");
    expectRefused("thunderbots.state-packet", {{"x.robot", "3"}}, Errc::UnknownName,
                  "thunderbots.state-packet x.robot");
    expectRefused("thunderbots.state-packet", {{"1.robot", "3"}, {"1.payload", block}, {"1.length", "11"}},
                  Errc::OutOfRange, "thunderbots.state-packet length");
    Fields many;
    for (int i = 1; i <= 6; ++i) {
        many.emplace_back(std::to_string(i) + ".robot", "0");
        many.emplace_back(std::to_string(i) + ".payload", block);
    }
    expectRefused("thunderbots.state-packet", many, Errc::OutOfRange, "thunderbots.state-packet length");
}

TEST(EncodeMessage, SaysWhichFieldWhichRangeAndWhatWasGiven) {
    const auto encoded = encodeMessage("thunderbots.drive", Fields{{"wheel2", "-1024"}});
    ASSERT_FALSE(encoded.has_value());
    EXPECT_EQ(encoded.error().code, Errc::OutOfRange);
    EXPECT_EQ(encoded.error().subject, "thunderbots.drive wheel2");
    EXPECT_EQ(encoded.error().lowest, -1023);
    EXPECT_EQ(encoded.error().highest, 1023);
    EXPECT_EQ(encoded.error().got, -1024);
}

TEST(EncodeMessage, RefusesWhatMakesNoSense) {
    expectRefused("thunderbots.nothing", {}, Errc::UnknownName, "thunderbots.nothing");
    expectRefused("", {}, Errc::UnknownName, "");
    expectRefused("thunderbots.firmware-request", {}, Errc::UnknownName, "thunderbots.firmware-request");
    expectRefused("thunderbots.drive", {{"wheel5", "1"}}, Errc::UnknownName, "thunderbots.drive wheel5");
    expectRefused("thunderbots.drive", {{"run", "1"}, {"run", "1"}}, Errc::BadArgument,
                  "thunderbots.drive run");
    for (const char* const text :
         {"", "fast", "1.5", "0x", "--1", "1 ", " 1", "99999999999999999999", "yes"}) {
        expectRefused("thunderbots.drive", {{"run", text}}, Errc::BadArgument, "thunderbots.drive run");
    }
    expectRefused("thunderbots.drive", {{"run", "2"}}, Errc::OutOfRange, "thunderbots.drive run");
    expectRefused("thunderbots.drive", {{"reserved", "1"}}, Errc::OutOfRange, "thunderbots.drive reserved");
    expectRefused("thunderbots.channels", {{"channel0", "14"}}, Errc::BadArgument,
                  "thunderbots.channels channel1");
    expectRefused("thunderbots.experiment", {{"data", "xy"}}, Errc::BadArgument,
                  "thunderbots.experiment data");
    expectRefused("thunderbots.experiment", {{"data", "00"}}, Errc::OutOfRange,
                  "thunderbots.experiment data");
    expectRefused("thunderbots.experiment", {}, Errc::BadArgument, "thunderbots.experiment data");
    expectRefused("thunderbots.test-mode", {{"class", "hall"}}, Errc::OutOfRange,
                  "thunderbots.test-mode target");
    expectRefused("thunderbots.parameters", {{"channel0", "5"}}, Errc::OutOfRange,
                  "thunderbots.parameters channel0");
    expectRefused("thunderbots.firmware-request.reboot", {{"opcode", "7"}}, Errc::OutOfRange,
                  "thunderbots.firmware-request.reboot opcode");
}

TEST(EncodeMessage, NamesWhatThereIs) {
    EXPECT_NE(errorOf(encodeMessage("?", {})).detail.find("thunderbots.feedback"), std::string::npos);
    EXPECT_EQ(errorOf(encodeMessage("thunderbots.kick", Fields{{"x", "1"}})).detail, "t1 mask1 t2 mask2 dt");
}

TEST(DecodeMessage, GivesNamesValuesUnitsAndLabels) {
    const auto feedback = decodeMessage("thunderbots.feedback", hex("0b 8d 03 00 08 6b 01 2c 01")).value();
    EXPECT_EQ(fieldOf(feedback, "valid").value, 1);
    EXPECT_EQ(fieldOf(feedback, "battery").value, 909);
    EXPECT_NEAR(fieldOf(feedback, "battery").physical.value(), 16.2540, 1e-3);
    EXPECT_EQ(fieldOf(feedback, "battery").unit, "V");
    EXPECT_NEAR(fieldOf(feedback, "capacitor").physical.value(), 166.65, 1e-9);
    EXPECT_EQ(fieldOf(feedback, "thermistor").unit, "°C");
    EXPECT_FALSE(fieldOf(feedback, "light").physical.has_value());
    const auto kick = decodeMessage("thunderbots.kick", hex("cb 80 00")).value();
    EXPECT_EQ(fieldOf(kick, "t1").value, 75);
    EXPECT_DOUBLE_EQ(fieldOf(kick, "t1").physical.value(), 2400);
    EXPECT_EQ(fieldOf(decodeMessage("thunderbots.test-mode", hex("02 05")).value(), "class").label, "hall");
    const auto drive = decodeMessage("thunderbots.drive", hex("80 05 40 00 00 00 00 00 00 00")).value();
    EXPECT_EQ(fieldOf(drive, "wheel1").value, 42);
    EXPECT_NEAR(fieldOf(drive, "wheel1").physical.value(), 350, 1e-9);
}

TEST(DecodeMessage, ShowsReservedBitsOnlyWhereTheyAreSet) {
    EXPECT_EQ(decodeMessage("thunderbots.drive", Bytes(10)).value().size(), 15U);
    const auto odd = decodeMessage("thunderbots.drive", hex("03 00 00 00 00 00 00 00 00 01")).value();
    EXPECT_EQ(odd.size(), 17U);
    EXPECT_EQ(fieldOf(odd, "reserved").value, 3);
}

TEST(DecodeMessage, TakesFamiliesAndLists) {
    const auto request = decodeMessage("thunderbots.firmware-request", hex("01 40 01 02 03")).value();
    EXPECT_EQ(fieldOf(request, "offset").value, 64);
    EXPECT_EQ(fieldOf(request, "data").bytes, hex("01 02 03"));
    const auto packet =
        decodeMessage("thunderbots.state-packet",
                      hex("0c 30 80 00 00 00 00 00 00 00 00 00 0b 41 00 00 00 00 00 00 00 00 00"))
            .value();
    EXPECT_EQ(fieldOf(packet, "1.robot").value, 3);
    EXPECT_EQ(fieldOf(packet, "2.pipe").value, 1);
    EXPECT_EQ(fieldOf(packet, "2.payload").bytes.size(), 9U);
    const auto errors = decodeMessage("thunderbots.error-queue", hex("29 ff")).value();
    EXPECT_EQ(fieldOf(errors, "1.code").label, "Robot 0: Message could not be sent");
    EXPECT_EQ(fieldOf(errors, "2.code").label, "Unknown fault code 255");
    EXPECT_TRUE(decodeMessage("thunderbots.state-packet", {}).value().empty());
}

TEST(DecodeMessage, SaysWhatIsWrong) {
    const auto wheel = decodeMessage("thunderbots.drive", hex("80 80 00 00 00 00 00 00 00 00"));
    ASSERT_FALSE(wheel.has_value());
    EXPECT_EQ(wheel.error().code, Errc::Malformed);
    EXPECT_EQ(wheel.error().subject, "thunderbots.drive wheel1");
    EXPECT_EQ(wheel.error().got, -1024);
    EXPECT_EQ(errorOf(decodeMessage("thunderbots.drive", hex("80"))).subject, "thunderbots.drive length");
    EXPECT_EQ(errorOf(decodeMessage("nothing", hex("80"))).code, Errc::UnknownName);
    EXPECT_EQ(errorOf(decodeMessage("thunderbots.firmware-request", hex("06"))).subject,
              "thunderbots.firmware-request opcode");
    EXPECT_EQ(errorOf(decodeMessage("thunderbots.firmware-request", {})).subject,
              "thunderbots.firmware-request length");
    EXPECT_EQ(errorOf(decodeMessage("thunderbots.firmware-request.reboot", hex("07"))).subject,
              "thunderbots.firmware-request.reboot opcode");
    const auto list =
        decodeMessage("thunderbots.state-packet", hex("0c 30 80 00 00 00 00 00 00 00 00 00 00"));
    ASSERT_FALSE(list.has_value());
    EXPECT_NE(list.error().detail.find("message 2"), std::string::npos);
    EXPECT_FALSE(decodeMessage("thunderbots.error-queue", Bytes(65)).has_value());
}

/// Whether no reserved bit is set and no field lies outside its range: some are read that way and never
/// given.
bool holdsOnlyWhatMayBeGiven(const MessageSpec& message, const Bytes& bytes) {
    return std::all_of(message.fields.begin(), message.fields.end(), [&](const FieldSpec& field) {
        if (field.kind == FieldKind::Bytes) return true;
        const std::int32_t value = readField(message, field, bytes);
        if (field.kind == FieldKind::Reserved) return value == 0;
        return value >= field.lowest && value <= field.highest;
    });
}

/// What the message's own codec says stands for the struct codecs: mayBeRead is the decoder itself.
TEST(GenericCodec, AgreesWithTheMessagesOwnCodecsOnRandomBytes) {
    std::mt19937 random(9);
    for (const MessageSpec& message : messages()) {
        if (message.maxListBytes != 0) continue;
        int taken = 0;
        for (int i = 0; i < 4'000; ++i) {
            Bytes bytes =
                randomBytes(random, static_cast<std::size_t>(between(random, 0, message.maxBytes + 1)));
            if (i % 2 == 0) bytes.resize(message.minBytes, 1);
            const bool isVariant = !message.fields.empty() && message.fields[0].kind == FieldKind::Opcode;
            if (isVariant && !bytes.empty()) bytes[0] = static_cast<std::uint8_t>(message.fields[0].lowest);
            // Small numbers, or no random message would ever be legal.
            for (auto& byte : bytes) {
                if (i % 4 < 2 && &byte != bytes.data()) byte &= 0x0F;
            }
            const auto decoded = decodeMessage(message.name, bytes);
            ASSERT_EQ(decoded.has_value(), message.mayBeRead(bytes).has_value())
                << message.name << ' ' << toHex(bytes);
            if (!decoded) continue;
            ++taken;
            const auto encoded = encodeMessage(message.name, textOf(*decoded));
            ASSERT_EQ(encoded.has_value(),
                      holdsOnlyWhatMayBeGiven(message, bytes) && message.mayBeSent(bytes).has_value())
                << message.name << ' ' << toHex(bytes);
            if (encoded) {
                ASSERT_EQ(*encoded, bytes) << message.name;
            }
        }
        EXPECT_GT(taken, 0) << message.name << " was never legal";
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
