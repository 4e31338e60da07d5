#include "ui/shell/panel.h"

namespace kickstand::ui {

Panel::Panel(Bench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {}

void Panel::setNote(const QString& note) {
    if (note == note_) return;
    note_ = note;
    emit noteChanged(note_);
}

}  // namespace kickstand::ui
