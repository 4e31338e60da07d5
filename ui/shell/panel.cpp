#include "ui/shell/panel.h"

#include <QLayout>

namespace kickstand::ui {

Panel::Panel(Bench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {}

int Panel::heightForWidth(int width) const {
    const bool wraps = layout() != nullptr && layout()->hasHeightForWidth();
    return wraps ? layout()->totalMinimumHeightForWidth(width) : -1;
}

void Panel::setNote(const QString& note) {
    if (note == note_) return;
    note_ = note;
    emit noteChanged(note_);
}

}  // namespace kickstand::ui
