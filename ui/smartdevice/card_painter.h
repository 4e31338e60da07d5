#pragma once

#include <QRectF>

#include "ui/smartdevice/card.h"

class QPainter;

namespace kickstand::ui {

struct Tokens;

/// Draws a card's parts into a rectangle; greyed where nothing comes from the board. The painter's state is
/// left as it was.
void drawCard(QPainter& painter, const QRectF& area, const CardContent& content, const Tokens& tokens,
              bool grey);

}  // namespace kickstand::ui
