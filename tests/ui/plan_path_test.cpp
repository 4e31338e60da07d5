// The drawing of a plan: what is seen of the step that executes and of the one that is chosen.
#include "ui/motionplan/plan_path.h"

#include <QImage>

#include <gtest/gtest.h>

#include "ui/widgets/tokens.h"

namespace kickstand::test {
namespace {

/// One straight step: its middle is the middle of the drawing.
class PlanDrawing : public testing::Test {
  protected:
    PlanDrawing() {
        path.resize(400, 300);
        path.setPlan({{motionplan::Wheels::BothForward, 100}});
    }
    QImage seen() { return path.grab().toImage(); }
    QColor middle() { return seen().pixelColor(200, 150); }
    /// Of the middle line, how many pixels have a colour.
    int across(const QColor& colour) {
        const QImage image = seen();
        int count = 0;
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, 150) == colour ? 1 : 0;
        return count;
    }
    const ui::Tokens& tokens() const { return ui::tokensOf(path.palette()); }

    ui::PlanPath path;
};

TEST_F(PlanDrawing, TheStepThatExecutesIsSeenThroughTheRobotThatIsOnIt) {
    path.setExecuting(1, 0.5);
    EXPECT_EQ(middle().name(), tokens().accent.name());
    // The robot's body is there as well.
    EXPECT_GT(across(tokens().accentSoft), 4);
}

TEST_F(PlanDrawing, TheChosenStepIsNotTakenForTheOneThatExecutes) {
    path.setChosen(0);
    EXPECT_EQ(across(tokens().accent), 0);
    EXPECT_GE(across(tokens().muted), 2);
    const QImage chosen = seen();
    path.setChosen(-1);
    path.setExecuting(1, 0);
    EXPECT_GT(across(tokens().accent), 2);
    EXPECT_EQ(across(tokens().muted), 0);
    path.setChosen(0);
    EXPECT_NE(seen(), chosen);
}

}  // namespace
}  // namespace kickstand::test
