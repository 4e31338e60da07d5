#include "core/engine/flow/bounded_queue.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace kickstand {
namespace {

TEST(BoundedQueue, GivesValuesInTheirOrder) {
    BoundedQueue<int> queue(3);
    EXPECT_FALSE(queue.tryPop());
    for (int lap = 0; lap < 5; ++lap) {
        EXPECT_TRUE(queue.tryPush(2 * lap));
        EXPECT_TRUE(queue.tryPush(2 * lap + 1));
        EXPECT_EQ(queue.size(), 2U);
        EXPECT_EQ(queue.tryPop(), 2 * lap);
        EXPECT_EQ(queue.tryPop(), 2 * lap + 1);
        EXPECT_FALSE(queue.tryPop());
    }
}

TEST(BoundedQueue, RefusesWhatDoesNotFitAndCountsIt) {
    BoundedQueue<std::unique_ptr<int>> queue(1);
    EXPECT_TRUE(queue.tryPush(std::make_unique<int>(1)));
    EXPECT_FALSE(queue.tryPush(std::make_unique<int>(2)));
    EXPECT_EQ(queue.refused(), 1U);
    EXPECT_EQ(**queue.tryPop(), 1) << "what was there stays";
    EXPECT_TRUE(queue.tryPush(std::make_unique<int>(3)));
    EXPECT_EQ(**queue.tryPop(), 3);
    EXPECT_EQ(queue.refused(), 1U);
}

TEST(BoundedQueue, KeepsNothingOfAValueThatWasTaken) {
    BoundedQueue<std::shared_ptr<int>> queue(4);
    const auto value = std::make_shared<int>(1);
    EXPECT_TRUE(queue.tryPush(value));
    EXPECT_EQ(value.use_count(), 2);
    queue.tryPop();
    EXPECT_EQ(value.use_count(), 1);
}

TEST(BoundedQueue, HasRoomForOneAtLeast) {
    BoundedQueue<std::string> queue(0);
    EXPECT_EQ(queue.capacity(), 1U);
    EXPECT_TRUE(queue.tryPush("a"));
    EXPECT_FALSE(queue.tryPush("b"));
}

}  // namespace
}  // namespace kickstand
