#include "core/engine/flow/snapshot_cell.h"

#include <string>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

TEST(SnapshotCell, HasNothingBeforeTheFirst) {
    const SnapshotCell<int> cell;
    EXPECT_EQ(cell.version(), 0U);
    EXPECT_EQ(cell.latest().value, nullptr);
    std::uint64_t seen = 0;
    EXPECT_EQ(cell.newerThan(seen), nullptr);
}

TEST(SnapshotCell, GivesTheLatestAndItsVersion) {
    SnapshotCell<std::string> cell;
    cell.publish(std::string("one"));
    cell.publish(std::string("two"));
    EXPECT_EQ(cell.version(), 2U);
    const auto latest = cell.latest();
    ASSERT_NE(latest.value, nullptr);
    EXPECT_EQ(*latest.value, "two");
    EXPECT_EQ(latest.version, 2U);
}

TEST(SnapshotCell, GivesEachReaderWhatIsNewToIt) {
    SnapshotCell<int> cell;
    std::uint64_t first = 0;
    std::uint64_t second = 0;
    cell.publish(1);
    EXPECT_EQ(*cell.newerThan(first), 1);
    EXPECT_EQ(cell.newerThan(first), nullptr);
    cell.publish(2);
    EXPECT_EQ(*cell.newerThan(first), 2);
    EXPECT_EQ(*cell.newerThan(second), 2);
    EXPECT_EQ(second, 2U);
}

TEST(SnapshotCell, ASnapshotThatIsHeldOutlivesItsSuccessor) {
    SnapshotCell<int> cell;
    cell.publish(1);
    auto held = cell.latest().value;
    const std::weak_ptr<const int> watch = held;
    cell.publish(2);
    EXPECT_EQ(*held, 1);
    held.reset();
    EXPECT_TRUE(watch.expired());
}

}  // namespace
}  // namespace kickstand
