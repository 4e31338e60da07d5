#include "ui/shell/window_menus.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QMessageBox>

#include "ui/shell/bench.h"
#include "ui/shell/focus_guard.h"
#include "ui/shell/main_window.h"
#include "ui/shell/panel.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/system_view.h"
#include "ui/shell/theme.h"
#include "ui/shell/workbench.h"

namespace kickstand::ui {

namespace {

constexpr const char* kGuidePage = "bench-guide.md";

/// The first control of a panel that can be used now, in the order of the Tab key; the dock where none can.
QWidget* firstControl(PanelDock& dock) {
    QWidget* const panel = dock.panel();
    for (QWidget* widget = panel->nextInFocusChain(); widget != panel; widget = widget->nextInFocusChain()) {
        const bool own = panel->isAncestorOf(widget);
        if (own && widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0)
            return widget;
    }
    return &dock;
}

}  // namespace

WindowMenus::WindowMenus(Bench& bench, MainWindow& window, Theme& theme, FocusGuard& focusGuard)
    : QObject(&window),
      bench_(bench),
      window_(window),
      theme_(theme),
      focusGuard_(focusGuard),
      view_(new QMenu(&window)),
      help_(new QMenu(&window)) {
    view_->setObjectName(QStringLiteral("viewMenu"));
    help_->setObjectName(QStringLiteral("helpMenu"));
    addPanels();
    addThemes();
    addUnits();
    addSettings();
    addHelp();
}

void WindowMenus::addPanels() {
    int number = 0;
    for (PanelDock* dock : window_.workbench().docks()) {
        QAction* show = dock->toggleViewAction();
        view_->addAction(show);
        auto* go = new QAction(&window_);
        go->setText(tr("Go to %1").arg(dock->windowTitle()));
        if (++number <= 9) go->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + number)));
        connect(go, &QAction::triggered, dock, [dock] {
            dock->show();
            dock->raise();
            firstControl(*dock)->setFocus(Qt::ShortcutFocusReason);
        });
        window_.addAction(go);
        // Its shortcut is the other action's: showing is not hiding.
        const QString keys = go->shortcut().toString(QKeySequence::NativeText);
        if (!keys.isEmpty()) show->setText(show->text() + u'\t' + keys);
    }
    view_->setToolTipsVisible(true);
    view_->addAction(tr("&Reset layout"), &window_.workbench(), &Workbench::resetLayout);
}

void WindowMenus::addThemes() {
    view_->addSection(tr("Theme"));
    auto* group = new QActionGroup(this);
    for (const auto& [text, choice] :
         {std::pair{tr("As the &system"), ThemeChoice::System}, std::pair{tr("&Light"), ThemeChoice::Light},
          std::pair{tr("&Dark"), ThemeChoice::Dark}}) {
        QAction* action = view_->addAction(text, this, [this, chosen = choice] { theme_.choose(chosen); });
        action->setCheckable(true);
        action->setChecked(theme_.choice() == choice);
        group->addAction(action);
    }
}

void WindowMenus::addUnits() {
    view_->addSection(tr("Units"));
    for (const auto& view : bench_.systems().views()) {
        for (const UnitChoice& choice : view->unitChoices()) {
            QMenu* menu = view_->addMenu(choice.text);
            menu->setObjectName(QStringLiteral("units_") + choice.id);
            auto* group = new QActionGroup(this);
            for (int i = 0; i < choice.units.size(); ++i) {
                QAction* action = menu->addAction(choice.units[i], this,
                                                  [this, id = choice.id, i] { bench_.chooseUnit(id, i); });
                action->setCheckable(true);
                action->setChecked(bench_.unitOf(choice.id) == i);
                group->addAction(action);
            }
        }
    }
}

void WindowMenus::addSettings() {
    view_->addSection(tr("Safety"));
    QAction* focus = view_->addAction(tr("Stop when the window loses the &keyboard"));
    focus->setObjectName(QStringLiteral("focusSetting"));
    focus->setCheckable(true);
    focus->setChecked(focusGuard_.isOn());
    focus->setToolTip(
        tr("While something moves. Switch it off to drive by gamepad with another window in front."));
    connect(focus, &QAction::toggled, this, [this](bool on) { focusGuard_.setOn(on); });
}

void WindowMenus::addHelp() {
    QAction* here = help_->addAction(tr("Help for this &panel"), this, &WindowMenus::helpOfFocus);
    here->setShortcut(QKeySequence(Qt::Key_F1));
    window_.addAction(here);
    help_->addAction(tr("&Bench guide"), this, [this] { window_.showHelp(QString::fromLatin1(kGuidePage)); });
    help_->addAction(tr("&Contents"), this, [this] { window_.showHelp(QStringLiteral("index.md")); });
    help_->addSeparator();
    QAction* doctor = help_->addAction(tr("&Why does it not work?"), &window_, &MainWindow::showDoctor);
    doctor->setObjectName(QStringLiteral("doctorAction"));
    help_->addSeparator();
    help_->addAction(tr("&About Kickstand"), this, &WindowMenus::showAbout);
}

void WindowMenus::helpOfFocus() {
    const PanelDock* dock = window_.workbench().currentDock();
    window_.showHelp(dock == nullptr ? QString::fromLatin1(kGuidePage) : dock->helpPage());
}

void WindowMenus::showAbout() {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Kickstand"),
        tr("<b>Kickstand %1</b><p>A bench for small robots: drive them, watch them, stop them.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later. It comes "
           "with no warranty.</p>")
            .arg(QApplication::applicationVersion().toHtmlEscaped()),
        QMessageBox::Close, &window_);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace kickstand::ui
