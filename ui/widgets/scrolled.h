#pragma once

class QScrollArea;
class QWidget;

namespace kickstand::ui {

/// Puts content where it can be scrolled up and down when there is too little room for it: without a frame,
/// on the ground that is behind it, and passed by with the Tab key.
QScrollArea* scrolled(QWidget* content, QWidget* parent);

}  // namespace kickstand::ui
