#pragma once

#include <QWidget>
#include <functional>

#include "ui/thunderbots/kick_presets.h"

class QAction;
class QComboBox;
class QInputDialog;

namespace kickstand::ui {

class KickSettings;

/// Chooses, saves, renames and deletes presets of pulses.
class KickPresetBox final : public QWidget {
    Q_OBJECT
  public:
    KickPresetBox(KickSettings& kick, QSettings& settings, QWidget* parent = nullptr);

  private:
    void refresh();
    void choose(int index);
    QString current() const;
    /// Keeps the pulses under a name; one that another preset has is asked for.
    void saveAs(const QString& name);
    void keep(const QString& name);
    /// Asks for a name; `named` gets it.
    void askName(const QString& title, const QString& first,
                 const std::function<void(const QString&)>& named);

    KickSettings& kick_;
    KickPresets presets_;
    QString chosen_;  ///< The preset that a person took last: of several with equal pulses, it is that.
    QComboBox* names_;
    QAction* rename_;
    QAction* remove_;
};

/// Asks for a line of text in a dialog of the program's own.
QInputDialog* askLine(QWidget* parent, const QString& title, const QString& label, const QString& first);

}  // namespace kickstand::ui
