// The real library, with a gamepad that exists in its memory alone.

#include "ui/gamepad/sdl_pads.h"

#include <gtest/gtest.h>

#include "ui/gamepad/pad_map.h"
#include "ui/gamepad/virtual_pad.h"

namespace kickstand::ui {
namespace {

class SdlPadsTest : public testing::Test {
  protected:
    SdlPads pads;
};

TEST_F(SdlPadsTest, OnePluggedInIsThereWithTheNextLook) {
    pads.update();
    const std::size_t before = pads.pads().size();
    VirtualPad pad(true);
    ASSERT_TRUE(pad.works());
    pads.update();
    ASSERT_EQ(pads.pads().size(), before + 1);
    EXPECT_TRUE(pads.pads().back().known);
    EXPECT_FALSE(pads.pads().back().name.empty());
    EXPECT_EQ(pads.pads().back().model.size(), 32U);
}

TEST_F(SdlPadsTest, ItsSticksAndButtonsAreWhereAStandardControllerHasThem) {
    VirtualPad pad(true);
    ASSERT_TRUE(pad.works());
    pads.update();
    const int id = pads.pads().back().id;
    pad.move(1, -1);
    pad.press(1, true);
    pads.update();
    const auto state = pads.state(id);
    ASSERT_TRUE(state);
    const PadMap map;
    EXPECT_NEAR(valueOf(*state, map.input(PadAction::Forward)), 1, 1e-3);
    EXPECT_EQ(valueOf(*state, map.input(PadAction::Left)), 0);
    EXPECT_EQ(valueOf(*state, map.input(PadAction::Stop)), 1);
    EXPECT_EQ(valueOf(*state, map.input(PadAction::Kick)), 0);
}

TEST_F(SdlPadsTest, OneThatIsPulledOutIsGone) {
    VirtualPad pad(true);
    ASSERT_TRUE(pad.works());
    pads.update();
    const int id = pads.pads().back().id;
    pad.unplug();
    pads.update();
    EXPECT_EQ(pads.state(id), std::nullopt);
    for (const PadInfo& info : pads.pads())
        EXPECT_NE(info.id, id);
}

TEST_F(SdlPadsTest, OnePluggedInAgainIsAnotherOneOfTheSameModel) {
    PadInfo first;
    {
        VirtualPad pad(true);
        ASSERT_TRUE(pad.works());
        pads.update();
        first = pads.pads().back();
    }
    pads.update();
    VirtualPad pad(true);
    ASSERT_TRUE(pad.works());
    pads.update();
    EXPECT_EQ(pads.pads().back().model, first.model);
    EXPECT_NE(pads.pads().back().id, first.id);
}

TEST_F(SdlPadsTest, AJoystickThatNobodyKnowsHasItsRawAxesAndButtons) {
    VirtualPad pad(false);
    ASSERT_TRUE(pad.works());
    pads.update();
    const PadInfo info = pads.pads().back();
    const auto state = pads.state(info.id);
    ASSERT_TRUE(state);
    if (info.known) GTEST_SKIP() << "this library knows every virtual joystick";
    EXPECT_EQ(state->axes.size(), static_cast<std::size_t>(VirtualPad::kAxes));
    EXPECT_EQ(state->buttons.size(), static_cast<std::size_t>(VirtualPad::kButtons + 4));
}

}  // namespace
}  // namespace kickstand::ui
