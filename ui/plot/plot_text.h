#pragma once

#include <QColor>
#include <QFont>
#include <QPixmap>

class QPainter;

namespace kickstand::ui {

/// The plot's small letters. Finding digits of one width takes time: made once a theme.
struct PlotFonts {
    QFont text;
    QFont strong;
    QFont number;
};
PlotFonts plotFonts();

/// What is behind a text.
enum class TextGround {
    Plate,  ///< Nothing is seen behind it.
    Halo,   ///< A thin rim around the letters, through which a curve still shows: it has no gap there.
};

/// What a text is drawn with.
struct TextLook {
    QColor ink;
    QColor ground;
    int padding = 2;  ///< On either side.
    int height = 13;
    TextGround kind = TextGround::Plate;
};

/// How wide a text is with its padding on either side.
int textWidth(const QFont& font, const QString& text, int padding);
/// Draws a text in the painter's font on its own ground. Laying it out takes time: the same few texts, many
/// times a second, are kept as pictures.
void drawText(QPainter& painter, const QPointF& topLeft, const QString& text, const TextLook& look);

}  // namespace kickstand::ui
