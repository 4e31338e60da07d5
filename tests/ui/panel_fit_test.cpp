// Every panel as it stands in the windows that it is made for: nothing of it is cut.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <array>

#include "tests/ui/bench_rig.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/workbench.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

bool isControl(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
           (qobject_cast<const QAbstractSlider*>(widget) != nullptr &&
            qobject_cast<const QScrollBar*>(widget) == nullptr) ||
           (qobject_cast<const QLineEdit*>(widget) != nullptr &&
            qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) == nullptr);
}

/// The parts that Qt makes such a thing of are its own affair.
bool isPartOfOne(const QWidget* widget) {
    for (const QWidget* parent = widget->parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
        if (isControl(parent)) return true;
    }
    return false;
}

/// What it takes to show all of a label or control. Some controls are lower than the style would have them.
QSize leastOf(const QWidget* widget) {
    if (const auto* label = qobject_cast<const QLabel*>(widget)) {
        if (label->text().isEmpty()) return {};
        if (label->wordWrap())
            return {label->minimumSizeHint().width(), label->heightForWidth(label->width())};
    }
    return widget->minimumSizeHint().boundedTo({QWIDGETSIZE_MAX, widget->fontMetrics().height() - 1});
}

const QScrollArea* scrollAreaOf(const QWidget* content) {
    const QWidget* viewport = content->parentWidget();
    const auto* area =
        viewport == nullptr ? nullptr : qobject_cast<const QScrollArea*>(viewport->parentWidget());
    return area != nullptr && area->widget() == content ? area : nullptr;
}

/// What cannot be seen of a widget, not even by scrolling.
QString cutOf(const QWidget* widget) {
    const QSize least = leastOf(widget);
    if (widget->width() < least.width())
        return QStringLiteral("%1 wide, needs %2").arg(widget->width()).arg(least.width());
    if (widget->height() < least.height())
        return QStringLiteral("%1 high, needs %2").arg(widget->height()).arg(least.height());
    QRect place = widget->rect();
    for (const QWidget* inner = widget; !inner->isWindow(); inner = inner->parentWidget()) {
        const QWidget* outer = inner->parentWidget();
        place.translate(inner->pos());
        if (const QScrollArea* area = scrollAreaOf(inner)) {
            // Scrolled to, it stands within the viewport.
            if (area->verticalScrollBarPolicy() != Qt::ScrollBarAlwaysOff &&
                place.height() <= outer->height() && inner->rect().contains(place.translated(-inner->pos())))
                place.moveTop(qBound(0, place.top(), outer->height() - place.height()));
            if (area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff &&
                place.width() <= outer->width())
                place.moveLeft(qBound(0, place.left(), outer->width() - place.width()));
        }
        if (!outer->rect().contains(place)) {
            return QStringLiteral("at %1,%2 %3x%4 reaches out of %5 \"%6\" of %7x%8")
                .arg(place.x())
                .arg(place.y())
                .arg(place.width())
                .arg(place.height())
                .arg(QLatin1String(outer->metaObject()->className()), outer->objectName())
                .arg(outer->width())
                .arg(outer->height());
        }
    }
    return {};
}

QString nameOf(const QWidget* widget) {
    const auto* label = qobject_cast<const QLabel*>(widget);
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return QStringLiteral("%1 %2 \"%3\"")
        .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
             label != nullptr    ? label->text()
             : button != nullptr ? button->text()
                                 : QString());
}

class PanelFitTest : public BenchTest {
  protected:
    /// Looks at every panel in its place, at each size that the window is made for.
    void expectNothingCut(const char* state) {
        int looked = 0;
        // The last is what a title bar leaves of the smallest screen.
        for (const QSize size : {kSizes[0], kSizes[1], QSize(1280, 768)}) {
            stand(size);
            for (const ui::PanelDock* dock : rig.window().workbench().docks()) {
                ASSERT_TRUE(bringForward(dock));
                const QString where = QStringLiteral("%1, %2 x %3, %4: ")
                                          .arg(QLatin1String(state))
                                          .arg(size.width())
                                          .arg(size.height())
                                          .arg(dock->objectName());
                looked += look(*dock, where);
            }
        }
        EXPECT_GT(looked, 400);
    }

    /// Nothing of these has to be looked for: they are worked with while the eyes are on a robot.
    void expectNothingScrolledAway(const char* state) {
        for (const QSize size : kSizes) {
            stand(size);
            for (const char* const panel : {"drive", "kick", "kicks", "gamepad", "simulated", "leds"}) {
                const auto* dock = rig.find<ui::PanelDock>(QLatin1String(panel));
                ASSERT_TRUE(bringForward(dock));
                for (const auto* area : dock->findChildren<QScrollArea*>()) {
                    EXPECT_EQ(area->verticalScrollBar()->maximum(), 0)
                        << state << ", " << size.width() << " wide, " << panel;
                    EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0)
                        << state << ", " << size.width() << " wide, " << panel;
                }
            }
        }
    }

    void choose(const char* list, int index) {
        auto* box = rig.find<QComboBox>(QLatin1String(list));
        box->setCurrentIndex(index);
        emit box->activated(index);
    }

  private:
    static constexpr std::array kSizes{QSize(1280, 800), QSize(1440, 900)};

    void stand(QSize size) {
        rig.window().resize(size);
        rig.window().workbench().resetLayout();
    }
    bool bringForward(const ui::PanelDock* dock) {
        rig.bench().goTo(dock->objectName());
        const bool there = waitUntil([dock] { return !dock->visibleRegion().isEmpty(); }) && rig.settle();
        // What the news has made of the words takes its place now.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        return there;
    }
    static int look(const ui::PanelDock& dock, const QString& where) {
        int looked = 0;
        for (const QWidget* widget : dock.findChildren<QWidget*>()) {
            const bool text = qobject_cast<const QLabel*>(widget) != nullptr;
            if ((!text && !isControl(widget)) || isPartOfOne(widget) || !widget->isVisibleTo(&dock)) continue;
            ++looked;
            const QString cut = cutOf(widget);
            EXPECT_TRUE(cut.isEmpty()) << (where + nameOf(widget)).toStdString() << ": " << cut.toStdString();
        }
        return looked;
    }
};

TEST_F(PanelFitTest, NothingIsCutWithNoRobotChosen) {
    expectNothingCut("none");
}

TEST_F(PanelFitTest, NothingIsCutWithOneRobotThatHasKicked) {
    rig.clickRobot(3);
    rig.simulate("ball", 3, 1);
    rig.bench().submit(SystemCommand{ArmHighVoltage{maskOf(3), true}});
    rig.bench().submit(SystemCommand{SetCharger{maskOf(3), true}});
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.robots[3].readings.charged; }));
    rig.bench().submit(SystemCommand{SetAutokick{maskOf(3), true, {true, true, 75, 0, 0}}});
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& s) {
        return s.robots[3].autokicks > 0 && !s.kicks->empty() &&
               s.kicks->back().measure == KickMeasure::Recharged;
    }));
    expectNothingCut("kicked");
    expectNothingScrolledAway("kicked");
}

TEST_F(PanelFitTest, NothingIsCutInTheOtherWaysOfWorking) {
    rig.clickRobot(3);
    rig.click(QStringLiteral("bodyMode"));
    rig.find<ui::SetPointSlider>(QStringLiteral("bodyTurn"))->field()->setValue(-900);
    ASSERT_TRUE(
        rig.waitForSnapshot([](const Snapshot& s) { return s.robots[3].told && s.robots[3].told->run; }));
    rig.bench().goTo(QStringLiteral("gamepad"));
    rig.click(QStringLiteral("padWheels"));
    choose("ledClass", static_cast<int>(wire::TestClass::Encoder));
    choose("ledTarget", 1);
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& s) {
        return s.robots[3].toldTestMode == wire::TestMode{wire::TestClass::Encoder, 2};
    }));
    expectNothingCut("other ways");
    expectNothingScrolledAway("other ways");
    rig.bench().goTo(QStringLiteral("drive"));
    rig.click(QStringLiteral("changeLimit"));
    expectNothingCut("limit");
}

TEST_F(PanelFitTest, NothingIsCutWithSixRobotsStopped) {
    rig.find<QWidget>(QStringLiteral("robot1"))->setFocus();
    rig.press(Qt::Key_A, Qt::ControlModifier);
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(rig.waitForStop());
    expectNothingCut("stopped");
}

}  // namespace
}  // namespace kickstand::test
