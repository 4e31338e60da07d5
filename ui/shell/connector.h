#pragma once

#include <QObject>
#include <QTimer>

#include "core/engine/messages.h"

class QMenu;
class QWidget;

namespace kickstand::ui {

class Bench;

/// Everything about connecting that the menu and the start page share: looking for hardware, offering
/// simulated robots, links typed by hand, recent ones. Nothing simulated becomes hardware, or the other way
/// round, unless a person asks.
class Connector final : public QObject {
    Q_OBJECT
  public:
    explicit Connector(Bench& bench, QWidget* window);

    /// Fills itself whenever it is about to be shown.
    QMenu* menu() const { return menu_; }
    /// Connects at the start to the only hardware there is, if there is one; else leaves the choice to a
    /// person.
    void connectToOnlyHardware() { waitsForHardware_ = true; }
    void connectTo(const LinkUri& uri);
    /// As connectTo(), and what is connected stays.
    void connectBeside(const LinkUri& uri);
    void askForLink();
    void lookAgain();

    static QString titleOf(const FoundDevice& found);

  signals:
    /// A found device cannot be opened now, and this is why.
    void obstructed(const kickstand::Error& error);

  private:
    void fillMenu();
    void addFound();
    void addPorts();
    /// Those of simulations, or those that look for hardware.
    void addOffers(const QString& title, bool simulated);
    void addRecent();
    void addSessions();
    void remember(const LinkUri& uri);
    void follow();

    Bench& bench_;
    QWidget* window_;
    QMenu* menu_;
    QTimer look_;
    bool waitsForHardware_ = false;
};

}  // namespace kickstand::ui
