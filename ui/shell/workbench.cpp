#include "ui/shell/workbench.h"

#include <QApplication>
#include <QSettings>

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
constexpr int kEventsHeight = 240;
/// What is left of the window's height when the bars and the events have theirs.
constexpr int kWorkHeight = 420;

}  // namespace

Workbench::Workbench(Bench& bench, QWidget* parent) : QMainWindow(parent, Qt::Widget), bench_(bench) {
    setDockOptions(AllowNestedDocks | AllowTabbedDocks);
    setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
    addPanels();
    firstLayout_ = saveState(kLayoutVersion);
}

void Workbench::addPanels() {
    QDockWidget* lastRight = nullptr;
    for (const auto& view : bench_.systems().views()) {
        for (const PanelEntry& entry : view->panels()) {
            auto* dock = new PanelDock(entry.id, entry.title, entry.helpPage, entry.make(bench_), this);
            addDockWidget(entry.area, dock);
            if (entry.area == Qt::RightDockWidgetArea) lastRight = dock;
            docks_.push_back(dock);
        }
    }
    auto* events = new PanelDock(QStringLiteral("events"), tr("Events"), QStringLiteral("bench-guide.md"),
                                 new EventsPanel(bench_), this);
    addDockWidget(Qt::RightDockWidgetArea, events);
    if (lastRight != nullptr) splitDockWidget(lastRight, events, Qt::Vertical);
    docks_.push_back(events);
    resizeDocks({docks_.front()}, {kSideWidth}, Qt::Horizontal);
    if (lastRight != nullptr) resizeDocks({lastRight, events}, {kWorkHeight, kEventsHeight}, Qt::Vertical);
}

PanelDock* Workbench::focusedDock() const {
    for (QWidget* widget = QApplication::focusWidget(); widget != nullptr; widget = widget->parentWidget()) {
        if (auto* dock = qobject_cast<PanelDock*>(widget)) return dock;
    }
    return nullptr;
}

void Workbench::restoreLayout() {
    restoreState(bench_.settings().value(kLayoutSetting).toByteArray(), kLayoutVersion);
}

void Workbench::saveLayout() const {
    bench_.settings().setValue(kLayoutSetting, saveState(kLayoutVersion));
}

void Workbench::resetLayout() {
    restoreState(firstLayout_, kLayoutVersion);
}

}  // namespace kickstand::ui
