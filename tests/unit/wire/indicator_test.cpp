#include "core/thunderbots/wire/indicator.h"

#include <numeric>

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

TEST(Indicator, NoPayloadIsAnAutokick) {
    const auto decoded = decodeIndicator({});
    ASSERT_TRUE(decoded.has_value());
    EXPECT_TRUE(std::holds_alternative<AutokickFired>(*decoded));
    EXPECT_TRUE(encodeIndicator(AutokickFired{}).value().empty());
}

TEST(Indicator, ThirtyThreeBytesAreExperimentData) {
    Bytes payload(33);
    std::iota(payload.begin(), payload.end(), std::uint8_t{96});
    const auto decoded = decodeIndicator(payload);
    ASSERT_TRUE(decoded.has_value());
    const auto& experiment = std::get<ExperimentData>(*decoded);
    EXPECT_EQ(experiment.offset, 96);
    EXPECT_EQ(experiment.data.front(), 97);
    EXPECT_EQ(experiment.data.back(), 128);
    EXPECT_EQ(bytesOf(encodeIndicator(*decoded).value()), payload);
}

TEST(Indicator, DataStaysWithinTheBuffer) {
    for (int offset = 0; offset < 256; ++offset) {
        Bytes payload(33);
        payload[0] = static_cast<std::uint8_t>(offset);
        ExperimentData experiment;
        experiment.offset = payload[0];
        ASSERT_EQ(decodeIndicator(payload).has_value(), offset <= 224) << offset;
        ASSERT_EQ(encodeIndicator(experiment).has_value(), offset <= 224) << offset;
    }
    Bytes late(33);
    late[0] = 225;
    expectFault(decodeIndicator(late), WireFault::BadValue, "offset");
}

TEST(Indicator, AnyOtherLengthIsRefused) {
    for (std::size_t length = 1; length <= 64; ++length) {
        if (length != 33) {
            expectFault(decodeIndicator(Bytes(length)), WireFault::BadLength, "length");
        }
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
