#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

namespace kickstand::ui {

/// The colours of one theme, by what they mean. Red is for STOP, live capacitors and failures only; amber for
/// what wants attention. Colour is never the only sign: a word or a shape goes with it.
struct Tokens {
    bool dark = false;
    QColor background;
    QColor surface;
    QColor line;
    QColor text;
    QColor muted;
    QColor accent;
    QColor accentSoft;
    QColor onAccent;
    QColor danger;
    QColor dangerSoft;
    QColor onDanger;
    QColor warn;
    QColor warnSoft;
    QColor ok;
    QColor grid;  ///< Hairlines inside a panel.
};

const Tokens& lightTokens();
const Tokens& darkTokens();
/// The tokens of the theme that a palette belongs to, told by its lightness: what a widget paints with
/// follows its palette and nothing else.
const Tokens& tokensOf(const QPalette& palette);
QPalette paletteOf(const Tokens& tokens);

/// Distances and sizes in device-independent pixels, on a grid of four.
namespace metrics {
inline constexpr int kGap = 8;
inline constexpr int kPadding = 12;
inline constexpr int kControlHeight = 30;
inline constexpr int kFieldHeight = 28;
inline constexpr int kPanelRadius = 8;
inline constexpr int kControlRadius = 6;
inline constexpr int kTextSize = 13;
inline constexpr int kSmallTextSize = 11;
}  // namespace metrics

/// The application's font at another size.
QFont textFont(int size_px, QFont::Weight weight = QFont::Normal);
/// The same for numbers: a font whose digits all have one width.
QFont numberFont(int size_px, QFont::Weight weight = QFont::Normal);

/// A number with its sign as typography has it: "−36", not "-36".
QString signedNumber(int value);
/// The same with so many decimals.
QString signedNumber(double value, int decimals);

}  // namespace kickstand::ui
