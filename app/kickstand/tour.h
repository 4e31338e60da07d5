#pragma once

#include <QDir>
#include <QObject>
#include <QTimer>
#include <functional>
#include <vector>

namespace kickstand::ui {
class Bench;
class MainWindow;
class Theme;
enum class ThemeChoice;
}  // namespace kickstand::ui

namespace kickstand::app {

struct TourBus;

/// One thing that the tour does.
struct TourStep {
    QString name;
    std::function<void()> act;
    /// Whether what was done has come about.
    std::function<bool()> done;
    /// Draws what there is to see, where it is not the window as it stands; empty for no picture at all.
    std::function<QPixmap()> picture;
};

/// Walks through the window on simulated robots: does the main jobs with the real controls, waits for what
/// they bring about, and writes a picture of each in light and dark. Made of steps that follow the engine's
/// state; it never waits in place.
class Tour final : public QObject {
    Q_OBJECT
  public:
    Tour(ui::MainWindow& window, ui::Bench& bench, ui::Theme& theme, TourBus& bus, const QString& folder);

    void start();

  signals:
    /// 0, or 1 where it could not be finished; standard error has said why.
    void finished(int code);

  private:
    void begin();
    void check();
    void goOn();
    void takePicture(ui::ThemeChoice theme);
    void fail(const QString& why);

    ui::Theme& theme_;
    QDir folder_;
    std::vector<TourStep> steps_;
    std::size_t current_ = 0;
    int pictures_ = 0;
    bool acted_ = false;
    bool over_ = false;
    QTimer watchdog_;
};

}  // namespace kickstand::app
