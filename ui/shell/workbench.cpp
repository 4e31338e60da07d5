#include "ui/shell/workbench.h"

#include <QAction>
#include <QApplication>
#include <QChildEvent>
#include <QLayout>
#include <QSettings>
#include <QStyle>
#include <QTabBar>
#include <QTimer>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "ui/shell/bench.h"
#include "ui/shell/events_panel.h"
#include "ui/shell/first_paint.h"
#include "ui/shell/panel.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/sim_panel.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr const char* kLayoutSetting = "window/docks";
constexpr const char* kSideSetting = "window/sideWidth";
constexpr int kLayoutVersion = 2;
constexpr int kSideWidth = 300;
constexpr int kAsideWidth = 276;
/// Its header and three whole lines.
constexpr int kLeastEventsHeight = 116;
/// A low window shows something of all panels.
constexpr double kMostWorkShare = 0.6;
/// For the banners that there are, and a window that is made larger and smaller again.
constexpr std::size_t kMostEarlierRows = 4;
/// Of what is left under the work panels.
constexpr double kBottomShare = 0.33;

}  // namespace

Workbench::Workbench(Bench& bench, QWidget* parent) : QMainWindow(parent, Qt::Widget), bench_(bench) {
    setDockOptions(AllowNestedDocks | AllowTabbedDocks);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
    addPanels();
    connect(qApp, &QApplication::focusChanged, this,
            [this](QWidget*, QWidget* focused) { followFocus(focused); });
    connect(this, &QMainWindow::tabifiedDockWidgetActivated, this,
            [this](QDockWidget* dock) { current_ = qobject_cast<PanelDock*>(dock); });
}

void Workbench::addPanels() {
    for (const auto& view : bench_.systems().views()) {
        for (const PanelEntry& entry : view->panels())
            addPanel(entry, view.get());
    }
    addPanel({QStringLiteral("events"), tr("Events"), QStringLiteral("bench-guide.md#events"),
              PanelPlace::Bottom, [](Bench& bench) -> Panel* { return new EventsPanel(bench); }});
    docks_.back()->setMinimumHeight(kLeastEventsHeight);
    addPanel({QStringLiteral("simulated"), tr("Simulation"),
              QStringLiteral("bench-guide.md#simulated-robots"), PanelPlace::Work,
              [](Bench& bench) -> Panel* { return new SimPanel(bench); }});
    simulated_ = docks_.back();
    placePanels();
    followSession();
    connect(&bench_, &Bench::sessionChanged, this, &Workbench::followSession);
    connect(&bench_, &Bench::placeAsked, this, &Workbench::go);
}

void Workbench::go(const QString& panel, const QString& detail) {
    for (PanelDock* dock : docks_) {
        if (dock->objectName() != panel) continue;
        dock->show();
        dock->raise();
        dock->panel()->showDetail(detail);
        current_ = dock;
    }
}

void Workbench::followSystem() {
    const SystemView* system = bench_.view();
    if (system == nullptr) system = shownSystem_;
    if (system == nullptr && !bench_.systems().views().empty())
        system = bench_.systems().views().front().get();
    for (std::size_t i = 0; i < docks_.size(); ++i) {
        if (owners_[i] == nullptr) continue;
        PanelDock* const dock = docks_[i];
        const bool own = owners_[i] == system;
        dock->toggleViewAction()->setVisible(own);
        if (own && withheld_.erase(dock) > 0) dock->show();
        if (own || dock->isHidden()) continue;
        withheld_.insert(dock);
        dock->hide();
    }
    if (std::exchange(shownSystem_, system) != system && shown_) {
        sizePanels();
        raiseFirst();
    }
}

void Workbench::followSession() {
    followSystem();
    const SessionSnapshot* session = bench_.session();
    const bool simulated = session != nullptr && session->uri.isSimulated();
    simulated_->toggleViewAction()->setVisible(simulated);
    simulated_->setVisible(simulated);
}

void Workbench::addPanel(const PanelEntry& entry, const SystemView* owner) {
    auto* dock = new PanelDock(
        entry.id, entry.title, entry.helpPage, [this, make = entry.make] { return make(bench_); }, this);
    connect(dock, &QDockWidget::visibilityChanged, dock, [this, dock](bool visible) {
        if (visible && shown_) dock->panel();
    });
    docks_.push_back(dock);
    places_.push_back(entry.place);
    owners_.push_back(owner);
    dock->installEventFilter(this);
}

QList<QDockWidget*> Workbench::docksAt(PanelPlace place) const {
    QList<QDockWidget*> docks;
    for (std::size_t i = 0; i < docks_.size(); ++i) {
        const bool foreign = owners_[i] != nullptr && owners_[i] != shownSystem_;
        if (places_[i] == place && (!foreign || shownSystem_ == nullptr)) docks.append(docks_[i]);
    }
    return docks;
}

void Workbench::placePanels() {
    QDockWidget* above = nullptr;
    // A row is split off the one above it before that one is split across.
    for (const PanelPlace place :
         {PanelPlace::Side, PanelPlace::Work, PanelPlace::Below, PanelPlace::Bottom, PanelPlace::Aside}) {
        const QList<QDockWidget*> docks = docksAt(place);
        if (docks.isEmpty()) continue;
        QDockWidget* first = docks.front();
        const QList<QDockWidget*> work = docksAt(PanelPlace::Work);
        addDockWidget(place == PanelPlace::Side ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, first);
        if (place == PanelPlace::Aside && !work.isEmpty()) {
            splitDockWidget(work.front(), first, Qt::Horizontal);
        } else if (place != PanelPlace::Side) {
            if (above != nullptr) splitDockWidget(above, first, Qt::Vertical);
            above = first;
        }
    }
    // Only now: what is split off a dock that has tabs would become one of them.
    for (const PanelPlace place :
         {PanelPlace::Side, PanelPlace::Work, PanelPlace::Below, PanelPlace::Bottom, PanelPlace::Aside}) {
        const QList<QDockWidget*> docks = docksAt(place);
        for (QDockWidget* dock : docks) {
            if (dock != docks.front()) tabifyDockWidget(docks.front(), dock);
            dock->show();
        }
    }
    raiseFirst();
}

void Workbench::raiseFirst() {
    for (const PanelPlace place :
         {PanelPlace::Work, PanelPlace::Aside, PanelPlace::Below, PanelPlace::Bottom}) {
        const QList<QDockWidget*> docks = docksAt(place);
        if (!docks.isEmpty()) docks.front()->raise();
    }
    // Nobody has asked for any of them.
    current_ = nullptr;
}

void Workbench::sizePanels() {
    const auto size = [this](std::initializer_list<std::pair<PanelPlace, int>> wanted,
                             Qt::Orientation orientation) {
        QList<QDockWidget*> docks;
        QList<int> sizes;
        for (const auto& [place, pixels] : wanted) {
            const QList<QDockWidget*> there = docksAt(place);
            if (there.isEmpty()) continue;
            docks.append(there.front());
            sizes.append(pixels);
        }
        resizeDocks(docks, sizes, orientation);
    };
    const int most = static_cast<int>(height() * kMostWorkShare);
    const int workHeight = shownSystem_ == nullptr ? 0 : qMin(most, shownSystem_->workHeight());
    const int left = height() - workHeight;
    const int bottom = qMax(kLeastEventsHeight, static_cast<int>(left * kBottomShare));
    // A system need not have panels at every place.
    const int aside = docksAt(PanelPlace::Aside).isEmpty() ? 0 : kAsideWidth;
    const int work = docksAt(PanelPlace::Below).isEmpty() ? height() - bottom : workHeight;
    const int workWidth = width() - kSideWidth - aside;
    size({{PanelPlace::Side, kSideWidth}, {PanelPlace::Work, workWidth}}, Qt::Horizontal);
    size({{PanelPlace::Work, workWidth}, {PanelPlace::Aside, kAsideWidth}}, Qt::Horizontal);
    size({{PanelPlace::Work, work}, {PanelPlace::Below, left - bottom}, {PanelPlace::Bottom, bottom}},
         Qt::Vertical);
}

void Workbench::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(shown_, true)) return;
    // Only now is there a size to share out: what was restored before was squeezed into less.
    restoreLayout();
    makeFrontPanels();
    if (!std::exchange(sized_, true)) {
        sizePanels();
        raiseFirst();
    } else {
        // The window may be larger than the one that was left.
        sideWidth_ = bench_.settings().value(kSideSetting).toInt();
        keepSideWidth();
    }
    fitted_ = size();
    rows_ = rowsNow();
    // The others can wait until there is something to look at.
    connect(new FirstPaint(*this), &FirstPaint::painted, this, [this] {
        bringFloatingForward();
        makeNextPanelSoon();
    });
}

void Workbench::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    keepSideWidth();
    keepRows();
    fitted_ = size();
    rows_ = rowsNow();
}

/// A larger window is for the work, not for wider tiles.
void Workbench::keepSideWidth() {
    const QList<QDockWidget*> side = docksAt(PanelPlace::Side);
    const QList<QDockWidget*> bottom = docksAt(PanelPlace::Bottom);
    if (sideWidth_ == 0 || side.isEmpty() || bottom.isEmpty()) return;
    const auto stands = [this](QDockWidget* dock, Qt::DockWidgetArea area) {
        return !dock->isHidden() && !dock->isFloating() && dockWidgetArea(dock) == area;
    };
    if (!stands(side.front(), Qt::LeftDockWidgetArea) || !stands(bottom.front(), Qt::RightDockWidgetArea))
        return;
    const int gap = style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
    const int rest = contentsRect().width() - gap - sideWidth_;
    if (rest > 0) resizeDocks({side.front(), bottom.front()}, {sideWidth_, rest}, Qt::Horizontal);
}

/// A banner that comes and goes takes height and gives it back: every row is then as high as it was.
void Workbench::keepRows() {
    if (height() == fitted_.height() || rows_.docks.isEmpty()) return;
    const auto isOf = [](int height) { return [height](const Rows& rows) { return rows.height == height; }; };
    std::erase_if(earlierRows_, isOf(rows_.height));
    earlierRows_.push_back(rows_);
    if (earlierRows_.size() > kMostEarlierRows) earlierRows_.erase(earlierRows_.begin());
    const auto same = std::find_if(earlierRows_.begin(), earlierRows_.end(), isOf(height()));
    if (same != earlierRows_.end()) resizeDocks(same->docks, same->heights, Qt::Vertical);
}

Workbench::Rows Workbench::rowsNow() const {
    const int gap = style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
    Rows rows{height(), {}, {}};
    // A row is as high as its panel with the tabs above it.
    int top = contentsRect().top();
    for (const PanelPlace place : {PanelPlace::Work, PanelPlace::Below, PanelPlace::Bottom}) {
        for (QDockWidget* dock : docksAt(place)) {
            if (dock->isHidden() || dock->isFloating() || dock->geometry().right() < 0) continue;
            const int bottom = dock->geometry().bottom() + 1;
            // A person has put it somewhere else.
            if (bottom <= top || dockWidgetArea(dock) != Qt::RightDockWidgetArea) return {};
            rows.docks.append(dock);
            rows.heights.append(bottom - top);
            top = bottom + gap;
            break;
        }
    }
    return rows;
}

bool Workbench::eventFilter(QObject* watched, QEvent* event) {
    // What the layout does while the window changes its size is not what a person wanted.
    if (event->type() != QEvent::Resize || !shown_) return QMainWindow::eventFilter(watched, event);
    if (width() == fitted_.width()) {
        const auto at =
            static_cast<std::size_t>(std::find(docks_.begin(), docks_.end(), watched) - docks_.begin());
        if (places_[at] == PanelPlace::Side) sideWidth_ = docks_[at]->width();
    }
    if (size() == fitted_) {
        rows_ = rowsNow();
        if (QApplication::mouseButtons() != Qt::NoButton) earlierRows_.clear();
    }
    return QMainWindow::eventFilter(watched, event);
}

void Workbench::makeFrontPanels() {
    if (!sized_) raiseFirst();
    layout()->activate();
    for (PanelDock* dock : docks_) {
        // A dock whose tab is not the front one stands out of sight to the left.
        if (!dock->isHidden() && dock->geometry().right() >= 0) dock->panel();
    }
}

void Workbench::makeNextPanelSoon() {
    QTimer::singleShot(0, this, &Workbench::makeNextPanel);
}

void Workbench::makeNextPanel() {
    for (PanelDock* dock : docks_) {
        if (dock->isMade()) continue;
        dock->panel();
        makeNextPanelSoon();
        return;
    }
}

void Workbench::makePanels() {
    for (PanelDock* dock : docks_)
        dock->panel();
}

/// What floats was shown before this window was: a window manager that did not know yet whose it is leaves it
/// behind.
void Workbench::bringFloatingForward() {
    for (PanelDock* dock : docks_) {
        if (!dock->isFloating() || dock->isHidden()) continue;
        dock->hide();
        dock->show();
    }
}

PanelDock* Workbench::currentDock() const {
    return current_ == nullptr || current_->visibleRegion().isEmpty() ? nullptr : current_;
}

void Workbench::childEvent(QChildEvent* event) {
    QMainWindow::childEvent(event);
    auto* tabs = event->polished() ? qobject_cast<QTabBar*>(event->child()) : nullptr;
    if (tabs == nullptr) return;
    // The tab that is in front already can be meant as well, and is not activated by a click.
    connect(tabs, &QTabBar::tabBarClicked, this, [this, tabs](int tab) { followTab(tabs->tabText(tab)); });
}

void Workbench::followTab(const QString& title) {
    for (PanelDock* dock : docks_) {
        if (!dock->isHidden() && dock->windowTitle() == title) current_ = dock;
    }
}

void Workbench::followFocus(QWidget* focused) {
    for (QWidget* widget = focused; widget != nullptr; widget = widget->parentWidget()) {
        auto* dock = qobject_cast<PanelDock*>(widget);
        if (dock == nullptr) continue;
        if (dock->parentWidget() == this) current_ = dock;
        return;
    }
}

void Workbench::restoreLayout() {
    sized_ = restoreState(bench_.settings().value(kLayoutSetting).toByteArray(), kLayoutVersion);
    // The panels of a system that was not at work then were withheld, not closed.
    for (const auto& view : bench_.systems().views()) {
        bool any = false;
        for (std::size_t i = 0; i < docks_.size(); ++i)
            any = any || (owners_[i] == view.get() && !docks_[i]->isHidden());
        for (std::size_t i = 0; i < docks_.size() && !any; ++i) {
            if (owners_[i] == view.get()) withheld_.insert(docks_[i]);
        }
    }
    followSession();
}

void Workbench::saveLayout() const {
    // Before it is shown a layout has no size: what would be saved is not what a person left.
    if (!shown_) return;
    bench_.settings().setValue(kLayoutSetting, saveState(kLayoutVersion));
    bench_.settings().setValue(kSideSetting, sideWidth_);
}

void Workbench::resetLayout() {
    for (PanelDock* dock : docks_) {
        dock->setFloating(false);
        removeDockWidget(dock);
    }
    // All of them have their places; those of other systems are withheld again.
    shownSystem_ = nullptr;
    withheld_.clear();
    placePanels();
    followSession();
    sizePanels();
    raiseFirst();
}

}  // namespace kickstand::ui
