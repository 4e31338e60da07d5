#include "core/base/bytes.h"

#include <array>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace kickstand {
namespace {

TEST(Bytes, LittleEndianIsLoadedFromAnywhere) {
    constexpr std::array<std::uint8_t, 5> kBytes{0x01, 0x02, 0x03, 0x04, 0x85};
    static_assert(loadLe16(kBytes, 0) == 0x0201);
    static_assert(loadLe16(kBytes, 3) == 0x8504);
    static_assert(loadLe24(kBytes, 2) == 0x850403);
    EXPECT_EQ(loadLe24(kBytes, 0), 0x030201U);
}

TEST(Bytes, WhatIsStoredIsLoaded) {
    std::array<std::uint8_t, 5> bytes{0xEE, 0xEE, 0xEE, 0xEE, 0xEE};
    storeLe16(bytes, 1, 0xBEEF);
    EXPECT_EQ(bytes, (std::array<std::uint8_t, 5>{0xEE, 0xEF, 0xBE, 0xEE, 0xEE}));
    storeLe24(bytes, 2, 0x12345678);
    EXPECT_EQ(bytes, (std::array<std::uint8_t, 5>{0xEE, 0xEF, 0x78, 0x56, 0x34}))
        << "24 bits, neighbours untouched";
}

TEST(ErrorCodes, HaveDistinctNames) {
    std::set<std::string> names;
    int count = 0;
    while (std::string(name(static_cast<Errc>(count))) != "unknown")
        names.insert(name(static_cast<Errc>(count++)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(names.contains("robot-not-alive"));
    EXPECT_TRUE(names.contains("heartbeat-stale"));
}

}  // namespace
}  // namespace kickstand
