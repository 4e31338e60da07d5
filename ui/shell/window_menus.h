#pragma once

#include <QObject>

class QMenu;

namespace kickstand::ui {

class Bench;
class FocusGuard;
class MainWindow;
class Theme;

/// The View and Help menus of the window, with their shortcuts.
class WindowMenus final : public QObject {
    Q_OBJECT
  public:
    WindowMenus(Bench& bench, MainWindow& window, Theme& theme, FocusGuard& focusGuard);

    QMenu* viewMenu() const { return view_; }
    QMenu* helpMenu() const { return help_; }

  private:
    void addPanels();
    void addThemes();
    void addUnits();
    void addSettings();
    void addHelp();
    void helpOfFocus();
    void showAbout();

    Bench& bench_;
    MainWindow& window_;
    Theme& theme_;
    FocusGuard& focusGuard_;
    QMenu* view_;
    QMenu* help_;
};

}  // namespace kickstand::ui
