#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/coach/wire/message.h"
#include "core/coach/wire/named_frame.h"
#include "core/coach/wire/velocity.h"

namespace kickstand::coach::wire {
namespace {

std::int64_t valueOf(const std::vector<NamedField>& fields, std::string_view name) {
    for (const NamedField& field : fields) {
        if (field.name == name) return field.value;
    }
    ADD_FAILURE() << "no field " << name;
    return 0;
}

std::vector<NamedField> decoded(const char* hex) {
    const auto fields = decodeNamedFrame(kFrameName, *parseHex(hex));
    EXPECT_TRUE(fields.has_value()) << (fields ? "" : fields.error().subject);
    return fields ? *fields : std::vector<NamedField>();
}

TEST(CoachWire, TheFramesOfTheSpecification) {
    const auto velocity = decoded("7e 00 07 01 01 af 05 00 03 70 d6");
    EXPECT_EQ(valueOf(velocity, "frame_id"), 1);
    EXPECT_EQ(valueOf(velocity, "destination"), 0xAF05);
    EXPECT_EQ(valueOf(velocity, "message"), 0x03);
    EXPECT_EQ(valueOf(velocity, "forward"), 7);
    EXPECT_EQ(valueOf(velocity, "turn"), 0);
    const auto morale = decoded("7e 00 07 81 af 05 28 00 23 fb 84");
    EXPECT_EQ(valueOf(morale, "source"), 0xAF05);
    EXPECT_EQ(valueOf(morale, "rssi"), -40);
    EXPECT_EQ(valueOf(morale, "morale"), -5);
    const auto available = decoded("7e 00 07 01 02 ff ff 00 21 00 dd");
    EXPECT_EQ(valueOf(available, "destination"), 0xFFFF);
    EXPECT_EQ(valueOf(available, "message"), 0x21);
    const auto status = decoded("7e 00 03 89 01 00 75");
    EXPECT_EQ(valueOf(status, "status"), 0);
}

TEST(CoachWire, WritesTheSameFrames) {
    const auto velocity = encodeNamedFrame(
        kFrameName,
        {{"frame_id", "1"}, {"destination", "0xaf05"}, {"message", "velocity"}, {"forward", "7"}});
    ASSERT_TRUE(velocity);
    EXPECT_EQ(toHex(*velocity), toHex(*parseHex("7e0007 0101af05000370d6")));
    const auto morale = encodeNamedFrame(kFrameName, {{"kind", "rx"},
                                                      {"source", "0xAF05"},
                                                      {"rssi", "-40"},
                                                      {"message", "update-morale"},
                                                      {"morale", "-5"}});
    ASSERT_TRUE(morale);
    EXPECT_EQ(*morale, *parseHex("7e000781af05280023fb84"));
    const auto available = encodeNamedFrame(kFrameName, {{"frame_id", "2"}, {"message", "available"}});
    ASSERT_TRUE(available);
    EXPECT_EQ(*available, *parseHex("7e00070102ffff002100dd"));
    const auto status = encodeNamedFrame(kFrameName, {{"kind", "tx-status"}, {"frame_id", "1"}});
    ASSERT_TRUE(status);
    EXPECT_EQ(*status, *parseHex("7e000389010075"));
}

TEST(CoachWire, RefusesWhatIsNoField) {
    const auto code = [](const std::vector<std::pair<std::string, std::string>>& fields) {
        const auto bytes = encodeNamedFrame(kFrameName, fields);
        return bytes ? Errc::Io : bytes.error().code;
    };
    EXPECT_EQ(code({{"message", "velocity"}, {"forward", "8"}}), Errc::OutOfRange);
    EXPECT_EQ(code({{"message", "velocity"}, {"forward", "x"}}), Errc::BadArgument);
    EXPECT_EQ(code({{"message", "velocity"}, {"morale", "1"}}), Errc::UnknownName);
    EXPECT_EQ(code({{"message", "velocity"}, {"turn", "1"}, {"turn", "2"}}), Errc::BadArgument);
    EXPECT_EQ(code({{"message", "volocity"}}), Errc::UnknownName);
    EXPECT_EQ(code({{"kind", "ty"}}), Errc::UnknownName);
    EXPECT_EQ(code({}), Errc::BadArgument);
    EXPECT_EQ(encodeNamedFrame("coach.fram", {}).error().code, Errc::UnknownName);
}

TEST(CoachWire, SaysWhatIsWrongWithBytes) {
    const auto subject = [](const char* hex) {
        const auto fields = decodeNamedFrame(kFrameName, *parseHex(hex));
        return fields ? std::string() : fields.error().subject;
    };
    EXPECT_EQ(subject("7e 00 07 01 01 af 05 00 03 70 d7"), "checksum");
    EXPECT_EQ(subject("7f 00 07 01 01 af 05 00 03 70 d6"), "delimiter");
    EXPECT_EQ(subject("7e 00 6f 01 01 af 05 00 03 70 d6"), "length");
    EXPECT_EQ(subject("7e 00 07 01 01 af 05 00 03 70"), "frame");
    EXPECT_EQ(subject("7e 00 07 01 01 af 05 00 03 70 d6 00"), "frame");
    EXPECT_EQ(subject("7e 00 07 01 01 af 05 00 10 70 c9"), "message");
    EXPECT_EQ(subject("7e 00 02 8a 00 75"), "kind");
    EXPECT_EQ(subject("7e 00 02 89 01 75"), "length");
}

TEST(CoachWire, EscapedFramesHaveTheirOwnName) {
    const std::vector<std::pair<std::string, std::string>> fields{
        {"frame_id", "0x7e"}, {"destination", "0xaf11"}, {"message", "free-analog"}, {"magnitude", "-100"}};
    const auto bytes = encodeNamedFrame(kEscapedFrameName, fields);
    ASSERT_TRUE(bytes);
    EXPECT_EQ((*bytes)[4], 0x7D);
    const auto back = decodeNamedFrame(kEscapedFrameName, *bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(valueOf(*back, "frame_id"), 0x7E);
    EXPECT_EQ(valueOf(*back, "magnitude"), -100);
}

TEST(CoachWire, EveryParameterOfEveryMessage) {
    for (const MessageSpec& spec : messages()) {
        EXPECT_EQ(findMessage(std::string_view(spec.name)), &spec);
        EXPECT_EQ(&specOf(spec.opcode), &spec);
        int legal = 0;
        for (int parameter = 0; parameter < 256; ++parameter) {
            const Message message{spec.opcode, static_cast<std::uint8_t>(parameter)};
            const auto back = decodeMessage(encodeMessage(message));
            if (!back) continue;
            ++legal;
            EXPECT_EQ(*back, message);
        }
        const int expected = spec.opcode == Opcode::AssertCommand ? 2
                             : spec.opcode == Opcode::FreeAnalog  ? 201
                                                                  : 256;
        EXPECT_EQ(legal, expected) << spec.name;
    }
}

TEST(CoachWire, VelocityNibbles) {
    EXPECT_EQ(parameterOf({7, 0}), 0x70);
    EXPECT_EQ(parameterOf({-7, 3}), 0xF3);
    EXPECT_EQ(velocityOf(0xF3), (Velocity{-7, 3}));
    EXPECT_EQ(velocityOf(0x88), Velocity{}) << "minus zero";
    for (int forward = -kTopLevel; forward <= kTopLevel; ++forward) {
        for (int turn = -kTopLevel; turn <= kTopLevel; ++turn)
            EXPECT_EQ(velocityOf(parameterOf({forward, turn})), (Velocity{forward, turn}));
    }
    EXPECT_FALSE(isVelocity({8, 0}));
    EXPECT_FALSE(isVelocity({0, -8}));
}

TEST(CoachWire, PercentagesSnapToTheNearestLevel) {
    for (int level = -kTopLevel; level <= kTopLevel; ++level)
        EXPECT_EQ(nearestLevel(percentOf(level)), level);
    EXPECT_EQ(nearestLevel(7), 0);
    EXPECT_EQ(nearestLevel(8), 1);
    EXPECT_EQ(nearestLevel(-52), -3) << "in the middle the smaller one";
    EXPECT_EQ(nearestLevel(1000), 7);
    EXPECT_EQ(nearestLevel(-1000), -7);
}

TEST(CoachWire, Addresses) {
    EXPECT_EQ(addressOf(Role::Towrp, 5), 0xAF05);
    EXPECT_EQ(addressOf(Role::Coach, 255), 0xBCFF);
    EXPECT_EQ(roleOf(0xAF00), Role::Towrp);
    EXPECT_EQ(roleOf(0xBC10), Role::Coach);
    EXPECT_FALSE(roleOf(0xFFFF));
    EXPECT_EQ(teamOf(0xBC10), 0x10);
}

}  // namespace
}  // namespace kickstand::coach::wire
