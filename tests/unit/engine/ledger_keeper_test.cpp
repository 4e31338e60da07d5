#include "core/engine/ledger_keeper.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using thunderbots::Event;
using thunderbots::EventKind;

constexpr Duration kLong = std::chrono::seconds(30);
const std::chrono::system_clock::time_point kNow{std::chrono::milliseconds(1'308'917'043'123)};

EngineEvent eventOf(EventKind kind, int robot, std::int64_t code, std::int64_t previous, const char* text) {
    return EngineEvent{1, SystemEvent(Event{kind, {}, robot, code, previous, 0, text})};
}

TEST(LedgerKeeper, KeepsEveryBlockThatIsReadAndItsSignatures) {
    Ledger ledger(":memory:");
    LedgerKeeper keeper(ledger);
    keeper.take(eventOf(EventKind::ParametersRead, 3, 0, 0, "00 0e 0f 03 78 00"), "usb:", kNow);
    keeper.take(eventOf(EventKind::SignaturesRead, 3, 0x1234, 0xFFFF, ""), "usb:", kNow);
    ASSERT_TRUE(ledger.flush(kLong));
    const auto records = *ledger.view().records;
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0].robot, 3);
    EXPECT_EQ(records[0].source, "usb:");
    EXPECT_EQ(records[0].time, kNow);
    EXPECT_EQ(records[0].block, (std::vector<std::uint8_t>{0, 14, 15, 3, 120, 0}));
    EXPECT_EQ(records[0].microcontrollerSignature, 0x1234);
    EXPECT_EQ(records[0].flashSignature, 0xFFFF);
}

TEST(LedgerKeeper, TakesNothingElse) {
    Ledger ledger(":memory:");
    LedgerKeeper keeper(ledger);
    keeper.take(eventOf(EventKind::ParametersApplied, 3, 0, 0, "00"), "usb:", kNow);
    keeper.take(eventOf(EventKind::ParametersRead, 3, 0, 0, "no hex"), "usb:", kNow);
    keeper.take(EngineEvent{0, EngineNote{}}, "usb:", kNow);
    ASSERT_TRUE(ledger.flush(kLong));
    EXPECT_TRUE(ledger.view().records->empty());
}

}  // namespace
}  // namespace kickstand
