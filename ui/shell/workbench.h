#pragma once

#include <QMainWindow>
#include <set>
#include <vector>

#include "ui/shell/system_view.h"

namespace kickstand::ui {

class PanelDock;

/// The docks with the panels of every system and the events. Layouts are remembered.
class Workbench final : public QMainWindow {
    Q_OBJECT
  public:
    explicit Workbench(Bench& bench, QWidget* parent = nullptr);

    const std::vector<PanelDock*>& docks() const { return docks_; }
    /// The dock that was last worked in or brought to the front, as far as it can be seen; null for none.
    PanelDock* currentDock() const;
    void restoreLayout();
    void saveLayout() const;
    /// As on the first day.
    void resetLayout();
    /// Makes the panels that nobody has looked at yet; otherwise that is done little by little after the
    /// window is there.
    void makePanels();

  protected:
    QMenu* createPopupMenu() override { return nullptr; }
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void childEvent(QChildEvent* event) override;

  private:
    /// How high the rows of the middle are, each by one of its panels, in a bench of some height.
    struct Rows {
        int height = 0;
        QList<QDockWidget*> docks;
        QList<int> heights;
    };

    void addPanels();
    /// `owner`: the system that the panel is of; null for the window's own.
    void addPanel(const PanelEntry& entry, const SystemView* owner = nullptr);
    /// Shows the panels of the system that is at work, and withholds those of the others.
    void followSystem();
    void placePanels();
    void sizePanels();
    void keepSideWidth();
    void keepRows();
    Rows rowsNow() const;
    void raiseFirst();
    void go(const QString& panel, const QString& detail);
    void followFocus(QWidget* focused);
    void followTab(const QString& title);
    void bringFloatingForward();
    void followSession();
    void makeFrontPanels();
    void makeNextPanel();
    void makeNextPanelSoon();
    QList<QDockWidget*> docksAt(PanelPlace place) const;

    Bench& bench_;
    std::vector<PanelDock*> docks_;
    std::vector<PanelPlace> places_;         ///< Of each dock.
    std::vector<const SystemView*> owners_;  ///< Of each dock.
    std::set<PanelDock*> withheld_;          ///< To be shown when their system is at work.
    const SystemView* shownSystem_ = nullptr;
    PanelDock* simulated_ = nullptr;  ///< There only for simulated links.
    PanelDock* current_ = nullptr;
    int sideWidth_ = 0;              ///< As a person left it; 0 before that is known.
    QSize fitted_;                   ///< That the panels were laid out for.
    Rows rows_;                      ///< In that size.
    std::vector<Rows> earlierRows_;  ///< In other sizes, the newest last.
    bool sized_ = false;             ///< Sizes are those that a person left.
    bool shown_ = false;             ///< The window has been there.
};

}  // namespace kickstand::ui
