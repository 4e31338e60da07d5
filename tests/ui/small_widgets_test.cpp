#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

#include "ui/widgets/banner.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {
namespace {

double luminance(const QColor& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double first = luminance(a);
    const double second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

TEST(Tokens, FollowTheLightnessOfThePalette) {
    EXPECT_FALSE(tokensOf(paletteOf(lightTokens())).dark);
    EXPECT_TRUE(tokensOf(paletteOf(darkTokens())).dark);
}

TEST(Tokens, EveryInkCanBeReadOnItsGround) {
    constexpr double kReadable = 4.5;
    for (const Tokens* t : {&lightTokens(), &darkTokens()}) {
        EXPECT_GE(contrast(t->text, t->surface), kReadable);
        EXPECT_GE(contrast(t->muted, t->surface), kReadable);
        EXPECT_GE(contrast(t->muted, t->accentSoft), kReadable);
        EXPECT_GE(contrast(t->danger, t->surface), kReadable);
        EXPECT_GE(contrast(t->danger, t->dangerSoft), kReadable);
        EXPECT_GE(contrast(t->onDanger, t->danger), kReadable);
        EXPECT_GE(contrast(t->warn, t->surface), kReadable);
        EXPECT_GE(contrast(t->warn, t->warnSoft), kReadable);
        EXPECT_GE(contrast(t->accent, t->accentSoft), kReadable);
        EXPECT_GE(contrast(t->onAccent, t->accent), kReadable);
    }
}

TEST(Tokens, NumbersHaveDigitsOfOneWidth) {
    const QFontMetrics metrics(numberFont(15));
    for (char16_t digit = u'0'; digit <= u'9'; ++digit) {
        EXPECT_EQ(metrics.horizontalAdvance(digit), metrics.horizontalAdvance(u'0'));
    }
}

TEST(SignedNumber, HasATypographicMinus) {
    EXPECT_EQ(signedNumber(-36), QStringLiteral("\u221236"));
    EXPECT_EQ(signedNumber(0), QStringLiteral("0"));
    EXPECT_EQ(signedNumber(7), QStringLiteral("7"));
    EXPECT_EQ(signedNumber(-10.66, 1), QStringLiteral("\u221210.7"));
    EXPECT_EQ(signedNumber(-0.04, 1), QStringLiteral("0.0"));
}

class SignedSpinBoxTest : public testing::Test {
  protected:
    SignedSpinBoxTest() {
        box.setRange(-100, 100);
        box.show();
        box.setFocus();
        box.selectAll();
    }

    SignedSpinBox box;
};

TEST_F(SignedSpinBoxTest, TakesBothMinuses) {
    QTest::keyClicks(&box, QStringLiteral("-5"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(box.value(), -5);
    EXPECT_EQ(box.text(), QStringLiteral("\u22125"));
    box.selectAll();
    QTest::keyClick(&box, Qt::Key_End);
    QTest::keyClick(&box, Qt::Key_0);
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(box.value(), -50);
}

TEST_F(SignedSpinBoxTest, GoesToTheNearestEndPastIt) {
    QTest::keyClicks(&box, QStringLiteral("4711"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(box.value(), 100);
}

TEST_F(SignedSpinBoxTest, LettersAreNoNumber) {
    QTest::keyClicks(&box, QStringLiteral("1a2+"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(box.value(), 12);
}

TEST_F(SignedSpinBoxTest, LeavingTheFieldGivesTheOldNumberBackWhereItWouldMoveSomething) {
    box.setLeavingGivesBack(true);
    QTest::keyClicks(&box, QStringLiteral("77"));
    QFocusEvent out(QEvent::FocusOut, Qt::TabFocusReason);
    QApplication::sendEvent(&box, &out);
    EXPECT_EQ(box.value(), 0);
    EXPECT_EQ(box.text(), QStringLiteral("0"));
}

TEST_F(SignedSpinBoxTest, LeavingTheFieldConfirmsASetting) {
    QTest::keyClicks(&box, QStringLiteral("77"));
    QFocusEvent out(QEvent::FocusOut, Qt::TabFocusReason);
    QApplication::sendEvent(&box, &out);
    EXPECT_EQ(box.value(), 77);
    EXPECT_EQ(box.text(), QStringLiteral("77"));
}

TEST(Segmented, ShowsWhatItIsToldAndOnlyAsks) {
    Segmented segmented({QStringLiteral("Run"), QStringLiteral("Brake")});
    QSignalSpy asked(&segmented, &Segmented::asked);
    segmented.setCurrent(1);
    segmented.button(0)->click();
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked.first().at(0).toInt(), 0);
    EXPECT_FALSE(segmented.button(0)->isChecked());
    EXPECT_TRUE(segmented.button(1)->isChecked());
}

TEST(StateLabel, IsReadWithItsWords) {
    StateLabel label;
    label.setState(Tone::Good, QStringLiteral("E-stop"), QStringLiteral("RUN"));
    EXPECT_EQ(label.accessibleName(), QStringLiteral("E-stop RUN"));
    EXPECT_GE(label.sizeHint().width(), label.fontMetrics().horizontalAdvance(QStringLiteral("E-stop RUN")));
}

TEST(Banner, TextFromOutsideIsNoMarkup) {
    Banner banner(Banner::Kind::Notice);
    banner.setText(QStringLiteral("<b>what</b>"), QStringLiteral("a & b"));
    EXPECT_EQ(banner.text(), QStringLiteral("<b>what</b> \u2014 a & b"));
}

TEST(Banner, ItsButtonsAreNeverADefault) {
    Banner banner(Banner::Kind::Danger);
    const QPushButton* button = banner.addButton(QStringLiteral("Re-arm"));
    EXPECT_FALSE(button->autoDefault());
    EXPECT_FALSE(button->isDefault());
}

/// A banner over what fills the rest of a window.
class BannerInAWindow : public testing::Test {
  protected:
    BannerInAWindow() {
        auto* column = new QVBoxLayout(&window);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        banner = new Banner(Banner::Kind::Danger, &window);
        banner->addButton(QStringLiteral("Re-arm   Ctrl+Shift+R"));
        column->addWidget(banner);
        column->addWidget(new QWidget(&window), 1);
        window.resize(kWide, 400);
        window.show();
    }
    /// Whether the banner becomes as high as its words need it to be, and no higher.
    testing::AssertionResult fits() {
        const auto* words = banner->findChild<QLabel*>();
        const auto does = [this, words] {
            return words->height() >= words->heightForWidth(words->width()) &&
                   banner->height() == banner->heightForWidth(banner->width());
        };
        if (QTest::qWaitFor(does, kPatience_ms)) return testing::AssertionSuccess();
        return testing::AssertionFailure()
               << "at " << banner->width() << " it is " << banner->height() << " high, and "
               << banner->heightForWidth(banner->width()) << " is needed";
    }

    static constexpr int kPatience_ms = 5000;
    static constexpr int kWide = 1440;
    QWidget window;
    Banner* banner = nullptr;
};

TEST_F(BannerInAWindow, IsAsHighAsItsWordsNeedAtEveryWidth) {
    QStringList words;
    for (int count = 0; count < 40; ++count) {
        words << QStringLiteral("robots may be live");
        banner->setText(QStringLiteral("STOPPED"), words.join(u' '));
        ASSERT_TRUE(fits()) << count << " times";
    }
    for (int width = kWide; width > 400; width -= 40) {
        window.resize(width, 400);
        ASSERT_TRUE(fits());
    }
    banner->setText(QStringLiteral("STOPPED"), {});
    EXPECT_TRUE(fits());
}

}  // namespace
}  // namespace kickstand::ui
