#include "core/smartdevice/wire/named_frame.h"

#include <map>

#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/smartdevice/wire/fields.h"

namespace kickstand::smartdevice::wire {
namespace {

using Fields = std::vector<NamedText>;

std::string encoded(std::string_view name, const Fields& fields) {
    const auto frame = encodeNamedFrame(name, fields);
    return frame ? toHex(*frame)
                 : std::string(kickstand::name(frame.error().code)) + " " + frame.error().subject;
}

std::map<std::string, std::string> decoded(std::string_view name, const char* hex) {
    const auto fields = decodeNamedFrame(name, *parseHex(hex));
    std::map<std::string, std::string> texts;
    EXPECT_TRUE(fields) << hex;
    if (!fields) return texts;
    for (const NamedField& field : *fields)
        texts[field.name] = (field.isBytes ? toHex(field.bytes) : std::to_string(field.value)) +
                            (field.label.empty() ? "" : " " + field.label);
    return texts;
}

Errc refusal(std::string_view name, const char* hex) {
    const auto fields = decodeNamedFrame(name, *parseHex(hex));
    return fields ? Errc::BadArgument : fields.error().code;
}

TEST(NamedFrame, PutsTheDocumentsVectorsTogether) {
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "ping"}}), "02 10 02 10 00");
    EXPECT_EQ(encoded("smartdevice.frame-hibike", {{"message", "ping"}}), "00 04 02 10 02 10");
    EXPECT_EQ(encoded("smartdevice.frame",
                      {{"message", "subscription-request"}, {"parameters", "0x5"}, {"delay_ms", "40"}}),
              "04 11 03 05 03 28 3f 00");
    EXPECT_EQ(encoded("smartdevice.frame",
                      {{"message", "device-write"}, {"parameters", "1"}, {"values", "0000003f"}}),
              "04 14 06 01 01 01 01 03 3f 2c 00");
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "error"}, {"code", "checksum"}}),
              "04 ff 01 fe 01 00");
}

TEST(Fields, HaveTheRangeThatTheirBytesHold) {
    for (const MessageSpec& message : messages()) {
        for (const FieldSpec& field : message.fields) {
            for (const std::size_t dialect : {0U, 1U}) {
                const bool number = field.kind != FieldKind::Uid && field.kind != FieldKind::Values;
                EXPECT_EQ(field.highest.at(dialect), number ? (1LL << 8 * field.bytes.at(dialect)) - 1 : 0)
                    << message.name << ' ' << field.name;
            }
        }
    }
}

TEST(NamedFrame, TakesFramesApart) {
    EXPECT_EQ(decoded("smartdevice.frame", "04 11 03 05 03 28 3f 00"),
              (std::map<std::string, std::string>{{"message", "17 subscription-request"},
                                                  {"parameters", "5 parameters 0, 2"},
                                                  {"delay_ms", "40"}}));
    const std::string hex = encoded("smartdevice.frame-hibike", {{"message", "subscription-response"},
                                                                 {"parameters", "3"},
                                                                 {"delay_ms", "500"},
                                                                 {"uid", "000c-05-0102030405060708"}});
    EXPECT_EQ(decoded("smartdevice.frame-hibike", hex.c_str()),
              (std::map<std::string, std::string>{
                  {"message", "18 subscription-response"},
                  {"parameters", "3 parameters 0, 1"},
                  {"delay_ms", "500"},
                  {"uid", "0c 00 05 01 02 03 04 05 06 07 08 000c-05-0102030405060708"}}));
}

TEST(NamedFrame, EveryMessageAndFieldComesBack) {
    for (const std::string_view name : {kFrameName, kHibikeFrameName}) {
        for (const MessageSpec& message : messages()) {
            const std::string hex = encoded(name, {{"message", message.name}});
            const auto fields = decoded(name, hex.c_str());
            EXPECT_EQ(fields.size(), message.fields.size() + 1) << message.name;
        }
    }
    EXPECT_EQ(namedFrameFields(), (std::vector<std::string>{"message", "parameters", "delay_ms", "uid",
                                                            "values", "heartbeat", "code"}));
}

TEST(NamedFrame, RefusesWhatMakesNoSense) {
    EXPECT_EQ(encoded("smartdevice.fame", {{"message", "ping"}}), "unknown-name smartdevice.fame");
    EXPECT_EQ(encoded("smartdevice.frame", {}), "bad-argument message");
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "pong"}}), "unknown-name pong");
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "ping"}, {"delay_ms", "1"}}),
              "unknown-name delay_ms");
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "device-read"}, {"parameters", "65536"}}),
              "out-of-range parameters");
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "device-read"}, {"parameters", "two"}}),
              "bad-argument parameters");
    EXPECT_EQ(
        encoded("smartdevice.frame", {{"message", "device-read"}, {"parameters", "1"}, {"parameters", "2"}}),
        "bad-argument parameters");
    EXPECT_EQ(encoded("smartdevice.frame",
                      {{"message", "subscription-response"}, {"uid", "000c-05-0102030405060708"}}),
              "bad-argument uid");
    EXPECT_EQ(encoded("smartdevice.frame", {{"message", "device-write"}, {"values", "0"}}),
              "bad-argument values");
}

TEST(NamedFrame, BytesThatAreNotOneWholeFrameAreMalformed) {
    for (const char* hex : {"", "00", "02 10 02 10", "02 10 02 10 00 00", "02 10 02 11 00", "05 10 02 10 00"})
        EXPECT_EQ(refusal("smartdevice.frame", hex), Errc::Malformed) << hex;
    for (const char* hex : {"", "00", "00 05 02 10 02 10", "04 02 10 02 10", "00 04 02 10 02 11"})
        EXPECT_EQ(refusal("smartdevice.frame-hibike", hex), Errc::Malformed) << hex;
    EXPECT_EQ(refusal("coach.frame", "00"), Errc::UnknownName);
}

}  // namespace
}  // namespace kickstand::smartdevice::wire
