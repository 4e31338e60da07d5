#pragma once

#include <QWidget>
#include <optional>

#include "core/engine/messages.h"

class QStackedWidget;

namespace kickstand::ui {

class Banner;
class Bench;
class Connector;
class DoctorWindow;
class FocusGuard;
class HelpWindow;
class StoppedFrame;
class Theme;
class Workbench;

/// The window: bar, banners, start page or panels, status. It owns what belongs to a window and nothing of
/// the robots.
class MainWindow final : public QWidget {
    Q_OBJECT
  public:
    MainWindow(Bench& bench, Theme& theme);

    Connector& connector() const { return *connector_; }
    Workbench& workbench() const { return *workbench_; }
    void showHelp(const QString& page);
    /// Opens "Why does it not work?".
    void showDoctor();
    /// Shows an error with its remedy until it is dismissed or something connects.
    void showProblem(const Error& error);
    /// Brakes and closes without a question: a signal asked for it.
    void closeNow();
    /// Before everything else, as somebody wants who has started the program again.
    void bringForward();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void build();
    void makeBanners();
    void refresh();
    QString simulatedText(const SessionSnapshot& shown) const;
    void refreshLeftBehind();
    void refreshProblem();
    void refreshStop();
    void refreshStoppedText();
    void copyRemedy();
    void saveLayout();

    Bench& bench_;
    Theme& theme_;
    FocusGuard* focusGuard_;
    Connector* connector_;
    Workbench* workbench_;
    QStackedWidget* pages_;
    Banner* simulated_ = nullptr;
    Banner* stopped_ = nullptr;
    Banner* leftBehind_ = nullptr;
    Banner* problem_ = nullptr;
    QWidget* copy_ = nullptr;
    QWidget* rearm_ = nullptr;
    QWidget* dismiss_ = nullptr;
    StoppedFrame* frame_;
    HelpWindow* help_ = nullptr;
    DoctorWindow* doctor_ = nullptr;
    std::optional<Error> shownProblem_;
    bool leaving_ = false;
};

}  // namespace kickstand::ui
