#include "core/ledger/ledger_store.h"

#include <fstream>
#include <iterator>

#include "tests/unit/ledger/ledger_files.h"

namespace kickstand {
namespace {

using testing::recordOf;
using testing::TemporaryFolder;

std::string contentsOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LedgerStore, WhatIsWrittenIsReadAgainAfterReopening) {
    const TemporaryFolder folder;
    ParameterRecord first = recordOf(3);
    ParameterRecord second = recordOf(15, 7);
    second.microcontrollerSignature = 0xFFFF;
    second.flashSignature = 0;
    second.note = "übernächster Dribbler; DROP TABLE parameters";
    second.source = "sim:thunderbots?robots=0-15";
    {
        LedgerStore store;
        ASSERT_TRUE(store.open(folder.path("fleet.sqlite")).has_value());
        ASSERT_TRUE(store.add(first).has_value());
        ASSERT_TRUE(store.add(second).has_value());
    }
    LedgerStore store;
    ASSERT_TRUE(store.open(folder.path("fleet.sqlite")).has_value());
    const auto listing = store.newest(10);
    ASSERT_TRUE(listing.has_value());
    ASSERT_EQ(listing->records.size(), 2U);
    second.id = listing->records[0].id;
    first.id = listing->records[1].id;
    EXPECT_EQ(listing->records[0], second);
    EXPECT_EQ(listing->records[1], first);
    EXPECT_GT(second.id, first.id);
    EXPECT_EQ(store.newest(1)->records.size(), 1U);
}

TEST(LedgerStore, SignaturesGoToTheNewestRecordOfThatRobotAndOnlyOnce) {
    LedgerStore store;
    ASSERT_TRUE(store.open(":memory:").has_value());
    ASSERT_TRUE(store.add(recordOf(3)).has_value());
    ASSERT_TRUE(store.add(recordOf(3)).has_value());
    ASSERT_TRUE(store.add(recordOf(4)).has_value());
    ASSERT_TRUE(store.add(SignatureRecord{"usb:", 3, 1, 2}).has_value());
    ASSERT_TRUE(store.add(SignatureRecord{"usb:", 3, 7, 8}).has_value());
    ASSERT_TRUE(store.add(SignatureRecord{"sim:thunderbots", 4, 9, 9}).has_value());
    const auto records = store.newest(10)->records;
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0].microcontrollerSignature, std::nullopt);
    EXPECT_EQ(records[1].microcontrollerSignature, 1);
    EXPECT_EQ(records[1].flashSignature, 2);
    EXPECT_EQ(records[2].microcontrollerSignature, std::nullopt);
}

TEST(LedgerStore, SignaturesNeverGoToARecordOfAnEarlierRun) {
    const TemporaryFolder folder;
    {
        LedgerStore store;
        ASSERT_TRUE(store.open(folder.path("fleet.sqlite")).has_value());
        ASSERT_TRUE(store.add(recordOf(3)).has_value());
    }
    LedgerStore store;
    ASSERT_TRUE(store.open(folder.path("fleet.sqlite")).has_value());
    ASSERT_TRUE(store.add(SignatureRecord{"usb:", 3, 1, 2}).has_value());
    EXPECT_EQ(store.newest(1)->records.front().microcontrollerSignature, std::nullopt);
}

TEST(LedgerStore, ANoteReplacesTheOneBefore) {
    LedgerStore store;
    ASSERT_TRUE(store.open(":memory:").has_value());
    ASSERT_TRUE(store.add(recordOf(3)).has_value());
    ASSERT_TRUE(store.setNote(1, "left").has_value());
    ASSERT_TRUE(store.setNote(1, "right").has_value());
    EXPECT_TRUE(store.setNote(99, "nobody").has_value());
    EXPECT_EQ(store.newest(1)->records.front().note, "right");
}

TEST(LedgerStore, AFileOfThisProjectIsRead) {
    const TemporaryFolder folder;
    LedgerStore store;
    ASSERT_TRUE(store.open(folder.copyOf("good.sqlite")).has_value());
    const auto listing = store.newest(10);
    ASSERT_TRUE(listing.has_value());
    ASSERT_EQ(listing->records.size(), 2U);
    EXPECT_EQ(listing->records[1].note, "the one with the new dribbler");
    EXPECT_EQ(listing->records[1].flashSignature, 0x5678);
}

TEST(LedgerStore, RowsThatMakeNoSenseAreCountedAndLeftAlone) {
    const TemporaryFolder folder;
    LedgerStore store;
    ASSERT_TRUE(store.open(folder.copyOf("rows-that-make-no-sense.sqlite")).has_value());
    const auto listing = store.newest(100);
    ASSERT_TRUE(listing.has_value());
    EXPECT_EQ(listing->records.size(), 1U);
    EXPECT_EQ(listing->unreadable, 10U);
}

TEST(LedgerStore, WhatIsNoLedgerIsRefusedAndNotTouched) {
    const TemporaryFolder folder;
    const std::pair<const char*, Errc> files[] = {
        {"newer.sqlite", Errc::Unsupported},       {"other-program.sqlite", Errc::Malformed},
        {"other-columns.sqlite", Errc::Malformed}, {"cut-off.sqlite", Errc::Malformed},
        {"no-database.sqlite", Errc::Malformed},
    };
    for (const auto& [name, code] : files) {
        SCOPED_TRACE(name);
        const std::string file = folder.copyOf(name);
        const std::string before = contentsOf(file);
        LedgerStore store;
        const auto opened = store.open(file);
        ASSERT_FALSE(opened.has_value());
        EXPECT_EQ(opened.error().code, code) << opened.error().detail;
        EXPECT_EQ(opened.error().subject, file);
        EXPECT_FALSE(opened.error().detail.empty());
        EXPECT_FALSE(store.isOpen());
        EXPECT_EQ(contentsOf(file), before);
    }
}

TEST(LedgerStore, APlaceThatCannotBeWrittenIsAnErrorOfTheSystem) {
    LedgerStore store;
    const auto opened = store.open("/proc/nowhere/fleet.sqlite");
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::Io);
}

}  // namespace
}  // namespace kickstand
