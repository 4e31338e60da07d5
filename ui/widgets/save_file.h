#pragma once

#include <QByteArray>
#include <QString>
#include <functional>

class QWidget;

namespace kickstand::ui {

/// Asks where to save something and writes it there, whole or not at all; what goes wrong is said. The dialog
/// is the program's own, so that STOP keys reach the program while it is open. `content` is asked for once a
/// place has been chosen; it must stay valid as long as `parent`.
void askToSave(QWidget* parent, const QString& title, const QString& name, const QString& suffix,
               const std::function<QByteArray()>& content);

}  // namespace kickstand::ui
