#pragma once

#include <QSize>

class QPainter;
class QStyleOption;
class QStyleOptionMenuItem;

namespace kickstand::ui {

/// How BenchStyle draws menus: quiet headings, room around the words.
void drawMenuPanel(const QStyleOption& option, QPainter& painter);
void drawMenuItem(const QStyleOptionMenuItem& item, QPainter& painter);
QSize menuItemSize(const QStyleOptionMenuItem& item);

}  // namespace kickstand::ui
