#include "ui/shell/workbench.h"

#include <QApplication>
#include <QSettings>
#include <utility>

#include "ui/shell/bench.h"
#include "ui/shell/events_panel.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/system_view.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr const char* kLayoutSetting = "window/docks";
constexpr int kLayoutVersion = 1;
constexpr int kSideWidth = 300;
constexpr int kWorkHeight = 332;
constexpr int kLeastEventsHeight = 160;

}  // namespace

Workbench::Workbench(Bench& bench, QWidget* parent) : QMainWindow(parent, Qt::Widget), bench_(bench) {
    setDockOptions(AllowNestedDocks | AllowTabbedDocks);
    setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
    addPanels();
}

void Workbench::addPanels() {
    for (const auto& view : bench_.systems().views()) {
        for (const PanelEntry& entry : view->panels()) {
            docks_.push_back(new PanelDock(entry.id, entry.title, entry.helpPage, entry.make(bench_), this));
            areas_.push_back(entry.area);
        }
    }
    docks_.push_back(new PanelDock(QStringLiteral("events"), tr("Events"), QStringLiteral("bench-guide.md"),
                                   new EventsPanel(bench_), this));
    areas_.push_back(Qt::RightDockWidgetArea);
    placePanels();
}

void Workbench::placePanels() {
    QDockWidget* above = nullptr;
    for (std::size_t i = 0; i < docks_.size(); ++i) {
        addDockWidget(areas_[i], docks_[i]);
        docks_[i]->show();
        if (areas_[i] != Qt::RightDockWidgetArea) continue;
        if (above != nullptr) splitDockWidget(above, docks_[i], Qt::Vertical);
        above = docks_[i];
    }
}

void Workbench::sizePanels() {
    QList<QDockWidget*> side;
    QList<QDockWidget*> right;
    for (PanelDock* dock : docks_)
        (dockWidgetArea(dock) == Qt::LeftDockWidgetArea ? side : right).append(dock);
    if (!side.isEmpty() && !right.isEmpty()) {
        resizeDocks({side.front(), right.front()}, {kSideWidth, width() - kSideWidth}, Qt::Horizontal);
    }
    QList<int> heights(right.size(), kWorkHeight);
    if (!heights.isEmpty()) heights.back() = qMax(kLeastEventsHeight, height() - kWorkHeight);
    resizeDocks(right, heights, Qt::Vertical);
}

void Workbench::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    // Only now is there a size to share out.
    if (!std::exchange(sized_, true)) sizePanels();
}

PanelDock* Workbench::focusedDock() const {
    for (QWidget* widget = QApplication::focusWidget(); widget != nullptr; widget = widget->parentWidget()) {
        if (auto* dock = qobject_cast<PanelDock*>(widget)) return dock;
    }
    return nullptr;
}

void Workbench::restoreLayout() {
    sized_ = restoreState(bench_.settings().value(kLayoutSetting).toByteArray(), kLayoutVersion);
}

void Workbench::saveLayout() const {
    bench_.settings().setValue(kLayoutSetting, saveState(kLayoutVersion));
}

void Workbench::resetLayout() {
    for (PanelDock* dock : docks_) {
        dock->setFloating(false);
        removeDockWidget(dock);
    }
    placePanels();
    sizePanels();
}

}  // namespace kickstand::ui
