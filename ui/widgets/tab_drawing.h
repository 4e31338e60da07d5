#pragma once

#include <QSize>

class QPainter;
class QStyleOptionTab;

namespace kickstand::ui {

/// How BenchStyle draws tabs: words alone, the chosen one underlined in the accent.
void drawTab(const QStyleOptionTab& tab, QPainter& painter);
QSize tabSize(const QStyleOptionTab& tab);

}  // namespace kickstand::ui
