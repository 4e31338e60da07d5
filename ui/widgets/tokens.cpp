#include "ui/widgets/tokens.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontMetrics>
#include <algorithm>
#include <cmath>

namespace kickstand::ui {

namespace {

Tokens makeLight() {
    Tokens t;
    t.background = QColor(0xf3f4f6);
    t.surface = QColor(0xffffff);
    t.line = QColor(0xd8dce2);
    t.text = QColor(0x1b1e23);
    t.muted = QColor(0x59626e);
    t.accent = QColor(0x0b63ce);
    t.accentSoft = QColor(0xe3eefc);
    t.onAccent = QColor(0xffffff);
    t.danger = QColor(0xc62828);
    t.dangerSoft = QColor(0xfde7e6);
    t.onDanger = QColor(0xffffff);
    t.warn = QColor(0x8a5300);
    t.warnSoft = QColor(0xfff1d0);
    t.ok = QColor(0x1b7a4b);
    t.grid = QColor(0xe6e9ed);
    return t;
}

Tokens makeDark() {
    Tokens t;
    t.dark = true;
    t.background = QColor(0x14171b);
    t.surface = QColor(0x1c2026);
    t.line = QColor(0x30363e);
    t.text = QColor(0xe7eaee);
    t.muted = QColor(0x9ba5b1);
    t.accent = QColor(0x5aa7ff);
    t.accentSoft = QColor(0x1b2f47);
    t.onAccent = QColor(0x08131f);
    t.danger = QColor(0xff6a5e);
    t.dangerSoft = QColor(0x3b1e1d);
    t.onDanger = QColor(0x240806);
    t.warn = QColor(0xf2b84b);
    t.warnSoft = QColor(0x3a2d12);
    t.ok = QColor(0x55c890);
    t.grid = QColor(0x2a3037);
    return t;
}

QColor mixed(const QColor& a, const QColor& b, float part) {
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * part,
                            a.greenF() + (b.greenF() - a.greenF()) * part,
                            a.blueF() + (b.blueF() - a.blueF()) * part);
}

bool digitsHaveOneWidth(const QFontMetrics& metrics) {
    const int width = metrics.horizontalAdvance(u'0');
    for (char16_t digit = u'1'; digit <= u'9'; ++digit) {
        if (metrics.horizontalAdvance(digit) != width) return false;
    }
    return true;
}

}  // namespace

const Tokens& lightTokens() {
    static const Tokens tokens = makeLight();
    return tokens;
}

const Tokens& darkTokens() {
    static const Tokens tokens = makeDark();
    return tokens;
}

const Tokens& tokensOf(const QPalette& palette) {
    return palette.color(QPalette::Active, QPalette::Window).lightness() < 128 ? darkTokens() : lightTokens();
}

QPalette paletteOf(const Tokens& tokens) {
    QPalette palette(tokens.surface, tokens.background);
    palette.setColor(QPalette::WindowText, tokens.text);
    palette.setColor(QPalette::Base, tokens.surface);
    palette.setColor(QPalette::AlternateBase, tokens.background);
    palette.setColor(QPalette::Text, tokens.text);
    palette.setColor(QPalette::ButtonText, tokens.text);
    palette.setColor(QPalette::BrightText, tokens.onDanger);
    palette.setColor(QPalette::PlaceholderText, tokens.muted);
    palette.setColor(QPalette::Highlight, tokens.accent);
    palette.setColor(QPalette::HighlightedText, tokens.onAccent);
    palette.setColor(QPalette::Link, tokens.accent);
    palette.setColor(QPalette::LinkVisited, tokens.accent);
    palette.setColor(QPalette::ToolTipBase, tokens.surface);
    palette.setColor(QPalette::ToolTipText, tokens.text);
    palette.setColor(QPalette::Mid, tokens.line);
    const QColor disabled = mixed(tokens.muted, tokens.surface, 0.35F);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(QPalette::Disabled, role, disabled);
    }
    palette.setColor(QPalette::Disabled, QPalette::Highlight, tokens.line);
    return palette;
}

QFont textFont(int size_px, QFont::Weight weight) {
    QFont font = QApplication::font();
    font.setPixelSize(size_px);
    font.setWeight(weight);
    return font;
}

QFont numberFont(int size_px, QFont::Weight weight) {
    QFont font = textFont(size_px, weight);
    if (digitsHaveOneWidth(QFontMetrics(font))) return font;
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(size_px);
    fixed.setWeight(weight);
    return fixed;
}

QString signedNumber(int value) {
    return value < 0 ? QStringLiteral("\u2212%1").arg(-value) : QString::number(value);
}

QString signedNumber(double value, int decimals) {
    const QString digits = QString::number(std::abs(value), 'f', decimals);
    // What is rounded to nothing has no sign.
    const bool nothing =
        std::all_of(digits.begin(), digits.end(), [](QChar c) { return c == u'0' || c == u'.'; });
    return value < 0 && !nothing ? u'\u2212' + digits : digits;
}

}  // namespace kickstand::ui
