#include "core/thunderbots/wire/wire_error.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace kickstand::thunderbots::wire {
namespace {

TEST(WireErrors, KeepTheirFactsOutside) {
    const Error error = toError({WireFault::BadValue, "wheel1", -1023, 1023, -1024}, "robot 3 drive");
    EXPECT_EQ(error.code, Errc::Malformed);
    EXPECT_EQ(error.subject, "robot 3 drive wheel1");
    EXPECT_EQ(error.lowest, -1023);
    EXPECT_EQ(error.highest, 1023);
    EXPECT_EQ(error.got, -1024);
    EXPECT_EQ(error.detail, "bad-value");
}

TEST(WireErrors, RefusedValuesAreNotMalformedBytes) {
    EXPECT_EQ(toError({WireFault::OutOfRange, "t1", 0, 127, 128}, "").code, Errc::OutOfRange);
    EXPECT_EQ(toError({WireFault::OutOfRange, "t1", 0, 127, 128}, "").subject, "t1");
}

TEST(WireErrors, FaultsHaveDifferentNames) {
    std::set<std::string> names;
    for (const WireFault fault : {WireFault::TooShort, WireFault::TooLong, WireFault::BadLength,
                                  WireFault::BadValue, WireFault::UnknownKind, WireFault::OutOfRange}) {
        names.insert(name(fault));
    }
    EXPECT_EQ(names.size(), 6U);
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
