#include "ui/thunderbots/drive_keys.h"

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint kStart{1000s};

TEST(DriveKeyMap, LettersAreFoundByTheirKeyCode) {
    const DriveKeyMap map;
    EXPECT_EQ(map.find('W'), DriveKey::Forward);
    EXPECT_EQ(map.find('E'), DriveKey::TurnRight);
    EXPECT_EQ(map.find('Z'), std::nullopt);
    EXPECT_EQ(map.find(' '), std::nullopt);
}

TEST(DriveKeyMap, ALetterThatIsTakenChangesPlaces) {
    DriveKeyMap map;
    EXPECT_TRUE(map.setLetter(DriveKey::Forward, 'S'));
    EXPECT_EQ(map.letter(DriveKey::Forward), 'S');
    EXPECT_EQ(map.letter(DriveKey::Back), 'W');
    EXPECT_TRUE(map.setLetter(DriveKey::Left, 'K'));
    EXPECT_EQ(map.find('A'), std::nullopt);
}

TEST(DriveKeyMap, OnlyLettersAndNotTheOneOfZero) {
    DriveKeyMap map;
    for (const char letter : {'Z', ' ', '1', 'a', '\0'})
        EXPECT_FALSE(map.setLetter(DriveKey::Forward, letter)) << letter;
    for (const char* letters : {"", "WSADQ", "WSADQEX", "WWADQE", "WSADQZ", "wsadqe"})
        EXPECT_FALSE(map.setLetters(letters)) << letters;
    EXPECT_EQ(map.letters(), DriveKeyMap::kDefault);
    EXPECT_TRUE(map.setLetters("IKJLUO"));
    EXPECT_EQ(map.letters(), "IKJLUO");
}

class HeldKeysTest : public testing::Test {
  protected:
    HeldKeys keys;
};

TEST_F(HeldKeysTest, KeysAddUpAndPullAgainstEachOther) {
    keys.press(DriveKey::Forward, false, kStart);
    keys.press(DriveKey::Left, false, kStart);
    EXPECT_EQ(keys.direction(), (BodyMotion{1, 1, 0}));
    keys.press(DriveKey::Back, false, kStart);
    EXPECT_EQ(keys.direction(), (BodyMotion{0, 1, 0}));
    keys.release(DriveKey::Forward, kStart);
    EXPECT_EQ(keys.direction(), (BodyMotion{-1, 1, 0}));
    keys.press(DriveKey::TurnRight, false, kStart);
    EXPECT_EQ(keys.direction(), (BodyMotion{-1, 1, -1}));
}

TEST_F(HeldKeysTest, AHeldKeyCountsForAsLongAsItRepeats) {
    keys.press(DriveKey::Forward, false, kStart);
    TimePoint now = kStart + HeldKeys::kFirstRepeat - 1ms;
    EXPECT_FALSE(keys.expire(now));
    for (int i = 0; i < 1000; ++i) {
        keys.press(DriveKey::Forward, true, now);
        now += HeldKeys::kNextRepeat - 1ms;
        ASSERT_FALSE(keys.expire(now));
    }
    EXPECT_TRUE(keys.any());
}

TEST_F(HeldKeysTest, ALostReleaseEndsWithTheRepeats) {
    keys.press(DriveKey::Forward, false, kStart);
    keys.press(DriveKey::Forward, true, kStart + 500ms);
    EXPECT_FALSE(keys.expire(kStart + 500ms + HeldKeys::kNextRepeat - 1ms));
    EXPECT_TRUE(keys.expire(kStart + 500ms + HeldKeys::kNextRepeat));
    EXPECT_FALSE(keys.any());
    EXPECT_FALSE(keys.expire(kStart + 10s));
}

TEST_F(HeldKeysTest, AKeyThatNeverRepeatsIsLetGo) {
    keys.press(DriveKey::Forward, false, kStart);
    EXPECT_TRUE(keys.expire(kStart + HeldKeys::kFirstRepeat));
}

TEST_F(HeldKeysTest, RepeatsOfOneKeepTheOtherAliveAndAfterwardsItHasATimeOfItsOwn) {
    keys.press(DriveKey::Forward, false, kStart);
    keys.press(DriveKey::Left, false, kStart + 100ms);
    for (TimePoint now = kStart + 600ms; now < kStart + 5s; now += 30ms)
        keys.press(DriveKey::Left, true, now);
    EXPECT_FALSE(keys.expire(kStart + 5s));
    keys.release(DriveKey::Left, kStart + 5s);
    EXPECT_TRUE(keys.isHeld(DriveKey::Forward));
    EXPECT_TRUE(keys.expire(kStart + 5s + HeldKeys::kFirstRepeat));
    EXPECT_FALSE(keys.any());
}

TEST_F(HeldKeysTest, AfterLettingGoARepeatPressesNothing) {
    keys.press(DriveKey::Forward, false, kStart);
    keys.letGo();
    keys.press(DriveKey::Forward, true, kStart + 30ms);
    EXPECT_FALSE(keys.any());
    keys.press(DriveKey::Forward, false, kStart + 60ms);
    EXPECT_TRUE(keys.any());
}

}  // namespace
}  // namespace kickstand::ui
