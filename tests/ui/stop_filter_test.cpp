#include "ui/shell/stop_filter.h"

#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextEdit>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

class StopFilterTest : public testing::Test {
  protected:
    StopFilterTest() {
        auto* column = new QVBoxLayout(&window);
        for (QWidget* widget :
             {static_cast<QWidget*>(button), static_cast<QWidget*>(line), static_cast<QWidget*>(text)}) {
            column->addWidget(widget);
        }
        window.show();
        QApplication::setActiveWindow(&window);
    }

    bool active = false;
    StopFilter filter{[this] { return active; }};
    QSignalSpy stops{&filter, &StopFilter::stopAsked};
    QWidget window;
    QPushButton* button = new QPushButton(QStringLiteral("press"), &window);
    QLineEdit* line = new QLineEdit(&window);
    QTextEdit* text = new QTextEdit(&window);
};

TEST_F(StopFilterTest, SpaceNeverPressesAButton) {
    QSignalSpy clicks(button, &QPushButton::clicked);
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    EXPECT_EQ(stops.count(), 1);
    EXPECT_EQ(clicks.count(), 0);
}

TEST_F(StopFilterTest, EnterDoesPressIt) {
    QSignalSpy clicks(button, &QPushButton::clicked);
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Return);
    EXPECT_EQ(clicks.count(), 1);
    QTest::keyClick(button, Qt::Key_Enter, Qt::KeypadModifier);
    EXPECT_EQ(clicks.count(), 2);
    EXPECT_EQ(stops.count(), 0);
}

TEST_F(StopFilterTest, TextsTakeSpacesOnlyAtRest) {
    for (QWidget* editor : {static_cast<QWidget*>(line), static_cast<QWidget*>(text)}) {
        active = false;
        editor->setFocus();
        QTest::keyClick(editor, Qt::Key_Space);
        EXPECT_EQ(stops.count(), 0);
        active = true;
        QTest::keyClick(editor, Qt::Key_Space);
        EXPECT_EQ(stops.count(), 1);
        stops.clear();
    }
    EXPECT_EQ(line->text(), QStringLiteral(" "));
    EXPECT_EQ(text->toPlainText(), QStringLiteral(" "));
}

TEST_F(StopFilterTest, ATextThatCannotBeTypedIntoIsNoReasonToWait) {
    line->setReadOnly(true);
    line->setFocus();
    QTest::keyClick(line, Qt::Key_Space);
    EXPECT_EQ(stops.count(), 1);
}

TEST_F(StopFilterTest, ModifiersMakeNoDifference) {
    button->setFocus();
    for (const Qt::KeyboardModifier modifier : {Qt::ShiftModifier, Qt::ControlModifier}) {
        QTest::keyClick(button, Qt::Key_Space, modifier);
    }
    EXPECT_EQ(stops.count(), 2);
}

TEST_F(StopFilterTest, EscClosesADialogAtRestAndStopsOtherwise) {
    QDialog dialog(&window);
    dialog.setModal(true);
    dialog.show();
    active = true;
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_EQ(stops.count(), 1);
    active = false;
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_EQ(stops.count(), 1);
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(stops.count(), 2);
}

}  // namespace
}  // namespace kickstand::ui
