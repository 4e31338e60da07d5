#include "ui/shell/main_window.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "core/engine/describe.h"
#include "core/engine/describe_stop.h"
#include "ui/shell/bench.h"
#include "ui/shell/connector.h"
#include "ui/shell/doctor_window.h"
#include "ui/shell/focus_guard.h"
#include "ui/shell/help_window.h"
#include "ui/shell/live_warning.h"
#include "ui/shell/remedy_text.h"
#include "ui/shell/sim_menu.h"
#include "ui/shell/start_page.h"
#include "ui/shell/status_strip.h"
#include "ui/shell/stopped_frame.h"
#include "ui/shell/system_view.h"
#include "ui/shell/top_bar.h"
#include "ui/shell/window_menus.h"
#include "ui/shell/workbench.h"
#include "ui/widgets/banner.h"

namespace kickstand::ui {

namespace {

constexpr const char* kGeometrySetting = "window/geometry";
constexpr QSize kFirstSize(1440, 900);
constexpr QSize kSmallest(960, 640);

}  // namespace

MainWindow::MainWindow(Bench& bench, Theme& theme)
    : bench_(bench),
      theme_(theme),
      focusGuard_(new FocusGuard(bench, this)),
      connector_(new Connector(bench, this)),
      workbench_(new Workbench(bench, this)),
      pages_(new QStackedWidget(this)),
      frame_(new StoppedFrame(this)) {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(tr("Kickstand"));
    setMinimumSize(kSmallest);
    const QSize frame(0, style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, this));
    resize(kFirstSize.boundedTo(screen()->availableSize() - frame));
    makeBanners();
    build();
    restoreGeometry(bench_.settings().value(kGeometrySetting).toByteArray());
    workbench_->restoreLayout();

    connect(&bench_, &Bench::changed, this, &MainWindow::refresh);
    connect(&bench_, &Bench::sessionChanged, this, [this] { shownProblem_.reset(); });
    connect(&bench_.client(), &EngineClient::stopChanged, this, &MainWindow::refreshStop);
    connect(&bench_, &Bench::connectRefused, this, &MainWindow::showProblem);
    connect(connector_, &Connector::obstructed, this, &MainWindow::showProblem);
    refresh();
}

void MainWindow::build() {
    auto* menus = new WindowMenus(bench_, *this, theme_, *focusGuard_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new TopBar(bench_, connector_->menu(), menus->viewMenu(), menus->helpMenu(), this));
    column->addWidget(simulated_);
    column->addWidget(stopped_);
    column->addWidget(leftBehind_);
    column->addWidget(problem_);
    auto* start = new StartPage(bench_, *connector_, pages_);
    auto* status = new StatusStrip(bench_, this);
    connect(start, &StartPage::doctorAsked, this, &MainWindow::showDoctor);
    connect(status, &StatusStrip::doctorAsked, this, &MainWindow::showDoctor);
    pages_->addWidget(start);
    pages_->addWidget(workbench_);
    column->addWidget(pages_, 1);
    column->addWidget(status);
}

void MainWindow::makeBanners() {
    simulated_ = new Banner(Banner::Kind::Warning, this);
    simulated_->setObjectName(QStringLiteral("simulatedBanner"));
    simulated_->addTrailing(new SimMenu(bench_, simulated_));

    stopped_ = new Banner(Banner::Kind::Danger, this);
    stopped_->setObjectName(QStringLiteral("stoppedBanner"));
    QPushButton* rearm = stopped_->addButton(tr("Re-arm   Ctrl+Shift+R"));
    rearm->setObjectName(QStringLiteral("rearm"));
    rearm->setAccessibleName(tr("Re-arm"));
    rearm_ = rearm;
    connect(rearm, &QPushButton::clicked, this, [this] { bench_.client().rearm(); });
    auto* shortcut = new QShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R), this);
    connect(shortcut, &QShortcut::activated, rearm, &QPushButton::click);

    leftBehind_ = new Banner(Banner::Kind::Danger, this);
    leftBehind_->setObjectName(QStringLiteral("leftBehindBanner"));
    QPushButton* safe = leftBehind_->addButton(tr("They are safe now"));
    safe->setObjectName(QStringLiteral("discharged"));
    connect(safe, &QPushButton::clicked, &bench_, &Bench::forgetLeftBehind);

    problem_ = new Banner(Banner::Kind::Notice, this);
    problem_->setObjectName(QStringLiteral("problemBanner"));
    QPushButton* copy = problem_->addButton(tr("Copy command"));
    copy->setObjectName(QStringLiteral("copyRemedy"));
    connect(copy, &QPushButton::clicked, this, &MainWindow::copyRemedy);
    copy_ = copy;
    QPushButton* dismiss = problem_->addButton(tr("Dismiss"));
    connect(dismiss, &QPushButton::clicked, this, [this] {
        shownProblem_.reset();
        refreshProblem();
    });
    dismiss_ = dismiss;
}

void MainWindow::refresh() {
    const SessionSnapshot* session = bench_.session();
    pages_->setCurrentIndex(session == nullptr && !bench_.isConnecting() ? 0 : 1);
    const bool simulated = session != nullptr && session->uri.isSimulated();
    if (simulated) simulated_->setText(tr("SIMULATED"), simulatedText(*session));
    simulated_->setVisible(simulated);
    refreshLeftBehind();
    refreshProblem();
    refreshStop();
}

QString MainWindow::simulatedText(const SessionSnapshot& shown) const {
    for (const SessionSnapshot& session : bench_.client().snapshot().sessions) {
        if (!session.uri.isSimulated())
            return tr("these robots are simulated; HARDWARE IS CONNECTED beside them");
    }
    return tr("%1, no hardware is connected").arg(bench_.view()->simulatedText(shown.uri));
}

void MainWindow::refreshProblem() {
    const SystemView* view = bench_.view();
    const Error* standing = view == nullptr ? nullptr : view->obstacle(bench_.session()->system);
    const Error* error = standing != nullptr ? standing : shownProblem_ ? &*shownProblem_ : nullptr;
    problem_->setVisible(error != nullptr);
    if (error == nullptr) return;
    const Description words = describe(*error);
    problem_->setText(words.what, remedyBesideCopy(words));
    copy_->setVisible(!words.remedyCommand.isEmpty());
    copy_->setToolTip(words.remedyCommand);
    dismiss_->setVisible(standing == nullptr);
}

void MainWindow::refreshLeftBehind() {
    const std::vector<Hazard>& hazards = bench_.leftBehind();
    QStringList lines;
    for (const Hazard& hazard : hazards)
        lines << hazardLine(hazard, bench_.client().now());
    const bool moves =
        std::any_of(hazards.begin(), hazards.end(), [](const Hazard& one) { return one.moves; });
    if (!hazards.empty())
        leftBehind_->setText(moves ? tr("LEFT MOVING OR LIVE") : tr("LEFT LIVE"),
                             lines.join(QStringLiteral("; ")));
    leftBehind_->setVisible(!hazards.empty());
}

void MainWindow::refreshStop() {
    const bool stopped = bench_.client().isStopped();
    if (stopped) refreshStoppedText();
    stopped_->setVisible(stopped);
    frame_->setVisible(stopped);
    frame_->raise();
}

void MainWindow::refreshStoppedText() {
    const StopReason reason = bench_.client().stopReason();
    QStringList told;
    QString hindrance;
    if (const SessionSnapshot* session = bench_.session()) {
        hindrance = bench_.view()->rearmHindrance(session->system);
        told = QStringList{hindrance, stoppedText(session->system, reason)};
        told.removeAll(QString());
    }
    stopped_->setText(tr("STOPPED \u2014 %1").arg(describe(reason)), told.join(u' '));
    rearm_->setEnabled(hindrance.isEmpty());
    rearm_->setToolTip(hindrance.isEmpty() ? tr("Lets robots be driven again. Nothing starts by itself.")
                                           : hindrance);
}

void MainWindow::showProblem(const Error& error) {
    shownProblem_ = error;
    refreshProblem();
}

void MainWindow::copyRemedy() {
    QApplication::clipboard()->setText(copy_->toolTip());
}

void MainWindow::showHelp(const QString& page) {
    if (help_ == nullptr) help_ = new HelpWindow(this);
    help_->showPage(page);
}

void MainWindow::showDoctor() {
    if (doctor_ == nullptr) {
        doctor_ = new DoctorWindow(bench_, this);
        connect(doctor_, &DoctorWindow::helpAsked, this,
                [this] { showHelp(QStringLiteral("bench-guide.md#when-something-does-not-work")); });
    }
    doctor_->show();
    doctor_->raise();
    doctor_->activateWindow();
}

void MainWindow::bringForward() {
    setWindowState(windowState() & ~Qt::WindowMinimized);
    show();
    raise();
    activateWindow();
}

void MainWindow::closeNow() {
    bench_.client().stop(StopReason::Person);
    leaving_ = true;
    close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const std::vector<Hazard> hazards = hazardsOf(bench_);
    if (bench_.isActive() || !hazards.empty()) bench_.client().stop(StopReason::Person);
    if (leaving_ || hazards.empty()) {
        saveLayout();
        event->accept();
        return;
    }
    event->ignore();
    if (findChild<QMessageBox*>(QStringLiteral("liveWarning")) != nullptr) return;
    QMessageBox* box = makeLiveWarning(hazards, bench_.client().now(), tr("Leave them live and quit"), this);
    connect(box, &QDialog::accepted, this, [this] {
        leaving_ = true;
        close();
    });
    box->open();
}

void MainWindow::saveLayout() {
    bench_.settings().setValue(kGeometrySetting, saveGeometry());
    workbench_->saveLayout();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    frame_->setGeometry(rect());
    QWidget::resizeEvent(event);
}

}  // namespace kickstand::ui
