#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace kickstand::ui {

/// Asks which files to open: one or several of those that `filters` name. The dialog is the program's own, so
/// that STOP keys reach the program while it is open. `chosen` is called once files have been chosen; it must
/// stay valid as long as `parent`.
void askToOpen(QWidget* parent, const QString& title, const QStringList& filters,
               const std::function<void(const QStringList& paths)>& chosen);

}  // namespace kickstand::ui
