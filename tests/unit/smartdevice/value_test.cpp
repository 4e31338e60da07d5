#include "core/smartdevice/wire/value.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/hex.h"

namespace kickstand::smartdevice::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string bytesText(const Value& value) {
    return toHex(bytesOf(value).view());
}

TEST(Value, EachTypeHasItsBytes) {
    EXPECT_EQ(bytesText(true), "01");
    EXPECT_EQ(bytesText(std::uint8_t{0xFE}), "fe");
    EXPECT_EQ(bytesText(std::int8_t{-2}), "fe");
    EXPECT_EQ(bytesText(std::uint16_t{0x1234}), "34 12");
    EXPECT_EQ(bytesText(std::int16_t{-2}), "fe ff");
    EXPECT_EQ(bytesText(std::uint32_t{0x12345678}), "78 56 34 12");
    EXPECT_EQ(bytesText(std::int32_t{-1}), "ff ff ff ff");
    EXPECT_EQ(bytesText(std::uint64_t{1}), "01 00 00 00 00 00 00 00");
    EXPECT_EQ(bytesText(std::int64_t{-1}), "ff ff ff ff ff ff ff ff");
    EXPECT_EQ(bytesText(0.5F), "00 00 00 3f");
    EXPECT_EQ(bytesText(0.5), "00 00 00 00 00 00 e0 3f");
}

TEST(Value, EveryTypeReadsWhatItWrote) {
    const std::vector<Value> all{true,
                                 std::uint8_t{200},
                                 std::int8_t{-100},
                                 std::uint16_t{60000},
                                 std::int16_t{-30000},
                                 std::uint32_t{4000000000},
                                 std::int32_t{-2000000000},
                                 std::numeric_limits<std::uint64_t>::max(),
                                 std::numeric_limits<std::int64_t>::min(),
                                 -0.25F,
                                 1e300};
    ASSERT_EQ(all.size(), static_cast<std::size_t>(kValueTypes - 1));
    for (const Value& value : all) {
        const ValueType type = typeOf(value);
        const RawValue bytes = bytesOf(value);
        EXPECT_EQ(bytes.size(), widthOf(type));
        EXPECT_EQ(readValue(type, bytes.view()), value) << name(type);
        EXPECT_EQ(fromText(type, toText(value), "p"), value) << name(type);
        EXPECT_EQ(valueType(name(type)), type);
        EXPECT_FALSE(readValue(type, Bytes(widthOf(type) + 1)));
        EXPECT_FALSE(readValue(type, Bytes(widthOf(type) - 1)));
    }
    EXPECT_EQ(valueType("uint8_t"), ValueType::Uint8);
    EXPECT_FALSE(valueType("uint24"));
}

TEST(Value, RawHasAnyWidthUpToEight) {
    const auto raw = readValue(ValueType::Raw, Bytes{1, 2, 3});
    ASSERT_TRUE(raw);
    EXPECT_EQ(toText(*raw), "01 02 03");
    EXPECT_EQ(fromText(ValueType::Raw, "010203", "p"), *raw);
    EXPECT_FALSE(toNumber(*raw));
    EXPECT_FALSE(readValue(ValueType::Raw, Bytes{}));
    EXPECT_FALSE(readValue(ValueType::Raw, Bytes(9)));
    EXPECT_FALSE(fromText(ValueType::Raw, "010203040506070809", "p"));
}

TEST(Value, ABoolIsTrueForAnyByteButZero) {
    EXPECT_EQ(readValue(ValueType::Bool, Bytes{7}), Value(true));
    EXPECT_EQ(readValue(ValueType::Bool, Bytes{0}), Value(false));
}

TEST(Value, NumbersThatDoNotFitAreRefused) {
    EXPECT_EQ(fromNumber(ValueType::Uint8, 255), Value(std::uint8_t{255}));
    EXPECT_FALSE(fromNumber(ValueType::Uint8, 256));
    EXPECT_FALSE(fromNumber(ValueType::Uint8, -1));
    EXPECT_FALSE(fromNumber(ValueType::Uint8, 1.5));
    EXPECT_EQ(fromNumber(ValueType::Int8, -128), Value(std::int8_t{-128}));
    EXPECT_FALSE(fromNumber(ValueType::Int8, -129));
    EXPECT_FALSE(fromNumber(ValueType::Uint64, std::ldexp(1.0, 64)));
    EXPECT_FALSE(fromNumber(ValueType::Int64, std::ldexp(1.0, 63)));
    EXPECT_TRUE(fromNumber(ValueType::Int64, -std::ldexp(1.0, 63)));
    EXPECT_FALSE(fromNumber(ValueType::Float, 1e39));
    EXPECT_FALSE(fromNumber(ValueType::Double, std::nan("")));
    EXPECT_FALSE(fromNumber(ValueType::Float, HUGE_VAL));
    EXPECT_EQ(fromNumber(ValueType::Bool, 1), Value(true));
    EXPECT_FALSE(fromNumber(ValueType::Bool, 2));
    EXPECT_FALSE(fromNumber(ValueType::Raw, 1));
}

TEST(Value, TextsThatAreNoValueAreRefusedWithTheirBounds) {
    const auto codeOf = [](ValueType type, const char* text) {
        const auto value = fromText(type, text, "p");
        return value ? Errc::Io : value.error().code;
    };
    for (const ValueType type : {ValueType::Bool, ValueType::Uint8, ValueType::Int64, ValueType::Float,
                                 ValueType::Double, ValueType::Raw}) {
        for (const char* text : {"", " ", "x", "1x", "--1", "0x", "0x-1", "nan", "inf"})
            EXPECT_EQ(codeOf(type, text), Errc::BadArgument) << name(type) << " " << text;
    }
    EXPECT_EQ(codeOf(ValueType::Uint8, "256"), Errc::OutOfRange);
    EXPECT_EQ(codeOf(ValueType::Int8, "-129"), Errc::OutOfRange);
    EXPECT_EQ(codeOf(ValueType::Uint64, "18446744073709551616"), Errc::OutOfRange);
    EXPECT_EQ(fromText(ValueType::Uint16, "0xFFFF", "p"), Value(std::uint16_t{65535}));
    EXPECT_EQ(fromText(ValueType::Bool, "on", "p"), Value(true));
    EXPECT_EQ(fromText(ValueType::Bool, "0", "p"), Value(false));
    const auto tooBig = fromText(ValueType::Int8, "200", "servo0");
    ASSERT_FALSE(tooBig);
    EXPECT_EQ(tooBig.error().subject, "servo0");
    EXPECT_EQ(tooBig.error().lowest, -128);
    EXPECT_EQ(tooBig.error().highest, 127);
}

}  // namespace
}  // namespace kickstand::smartdevice::wire
