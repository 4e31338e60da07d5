// The desktop program: puts engine, systems and window together.

#include <QApplication>
#include <QIcon>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

#include "app/composition/composition.h"
#include "app/composition/ledger_file.h"
#include "app/kickstand/options.h"
#include "app/kickstand/tour.h"
#include "app/kickstand/tour_links.h"
#include "core/engine/engine.h"
#include "core/ledger/ledger.h"
#include "ui/coach/coach_view.h"
#include "ui/motionplan/motionplan_view.h"
#include "ui/shell/bench.h"
#include "ui/shell/connector.h"
#include "ui/shell/first_paint.h"
#include "ui/shell/ledger_feed.h"
#include "ui/shell/main_window.h"
#include "ui/shell/signal_watch.h"
#include "ui/shell/single_instance.h"
#include "ui/shell/stop_filter.h"
#include "ui/shell/suspend_watch.h"
#include "ui/shell/system_view.h"
#include "ui/shell/theme.h"
#include "ui/shell/translations.h"
#include "ui/smartdevice/smartdevice_view.h"
#include "ui/thunderbots/thunderbots_view.h"

namespace {

using namespace kickstand;

constexpr QSize kTourSize(1440, 900);
constexpr Duration kTourPatience = std::chrono::seconds(10);

/// What can wait until the window has been painted: buses may take their time.
void afterFirstPaint(ui::Theme& theme, ui::EngineClient& client) {
    theme.followSystem();
    auto* suspend = new ui::SuspendWatch(&client);
    QObject::connect(suspend, &ui::SuspendWatch::aboutToSleep, &client,
                     [&client] { client.stop(StopReason::Suspend); });
}

bool isGiven(int argc, char** argv, std::initializer_list<std::string_view> names) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        for (const std::string_view name : names) {
            if (argument.substr(0, argument.find('=')) == name) return true;
        }
    }
    return false;
}

/// A tour needs no display; a window does, and Qt would end the program with a core dump for want of one.
void chooseScreen(int argc, char** argv) {
#ifdef Q_OS_LINUX
    const bool display = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    if (display || qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || isGiven(argc, argv, {"-platform"})) return;
    if (isGiven(argc, argv, {"--tour"})) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        return;
    }
    std::fputs(
        "kickstand: there is no display. Start it on a desktop, or have it draw itself with --tour DIR.\n",
        stderr);
    std::exit(1);
#endif
}

/// A folder of this user alone, gone with the session where the system has one.
QString instanceFolder() {
    const QString runtime = QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation);
    return runtime.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)
                             : runtime;
}

int leaveToOther(const kickstand::app::Options& options) {
    std::fputs("kickstand: a window is open already and was asked to show itself.", stderr);
    std::fputs(options.links.empty() ? "\n" : " Connect there, or start with --new-instance.\n", stderr);
    return options.links.empty() ? 0 : 1;
}

void announcePainted() {
    std::puts("painted");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName(QStringLiteral("kickstand"));
    QCoreApplication::setOrganizationName(QStringLiteral("kickstand"));
    QCoreApplication::setApplicationVersion(QStringLiteral(KICKSTAND_VERSION));
    if (isGiven(argc, argv, {"-h", "--help", "--help-all", "-v", "--version"})) {
        // Words need no display.
        const QCoreApplication words(argc, argv);
        app::readOptions(QCoreApplication::arguments());
    }
    chooseScreen(argc, argv);
    QApplication application(argc, argv);
    ui::installTranslations();
    QApplication::setApplicationDisplayName(QStringLiteral("Kickstand"));
    const app::Options options = app::readOptions(QApplication::arguments());

    ui::SingleInstance instance(instanceFolder());
    if (!options.newInstance && !instance.claim()) return leaveToOther(options);

    // A tour neither reads nor changes what is remembered of this person.
    const QTemporaryDir scratch;
    QSettings remembered;
    QSettings forgotten(scratch.filePath(QStringLiteral("tour.ini")), QSettings::IniFormat);
    QSettings& settings = options.tourFolder ? forgotten : remembered;
    ui::Theme theme(settings);
    if (options.theme) theme.useNow(*options.theme);

    EngineOptions engineOptions;
    // Drawing pictures takes longer than a hand may be off a real robot; these are simulated.
    if (options.tourFolder) engineOptions.heartbeatLimit = kTourPatience;
    const auto tourBus = std::make_shared<app::TourBus>();
    Engine engine(options.tourFolder ? app::makeTourLinks(makeLinkProvider(), tourBus) : makeLinkProvider(),
                  engineOptions);
    ui::EngineClient client(engine);
    Ledger ledger(options.tourFolder ? ":memory:" : ledgerFile());
    const ui::LedgerFeed feed(client, ledger);
    ui::SystemRegistry systems;
    systems.add(std::make_unique<ui::ThunderbotsView>(ledger));
    systems.add(std::make_unique<ui::MotionplanView>());
    systems.add(std::make_unique<ui::CoachView>());
    systems.add(std::make_unique<ui::SmartdeviceView>());
    ui::Bench bench(client, systems, settings);
    ui::StopFilter stopFilter([&bench] { return bench.isActive(); });
    QObject::connect(&stopFilter, &ui::StopFilter::stopAsked, &client,
                     [&client] { client.stop(StopReason::Person); });

    ui::MainWindow window(bench, theme);
    QObject::connect(&instance, &ui::SingleInstance::showAsked, &window, &ui::MainWindow::bringForward);
    ui::SignalWatch signalWatch;
    QObject::connect(&signalWatch, &ui::SignalWatch::quitAsked, &window, &ui::MainWindow::closeNow);
    std::unique_ptr<app::Tour> tour;
    if (options.tourFolder) {
        // On simulated robots, whatever is plugged in.
        tour = std::make_unique<app::Tour>(window, bench, theme, *tourBus, *options.tourFolder);
    } else if (options.links.empty()) {
        window.connector().connectToOnlyHardware();
    }
    for (const LinkUri& link : options.links)
        window.connector().connectBeside(link);
    if (tour) {
        window.resize(kTourSize);
        QObject::connect(tour.get(), &app::Tour::finished, &application, &QCoreApplication::exit);
        QTimer::singleShot(0, tour.get(), &app::Tour::start);
    }
    auto* firstPaint = new ui::FirstPaint(window);
    QObject::connect(firstPaint, &ui::FirstPaint::painted, &client, [&theme, &client, &options] {
        if (options.announce) announcePainted();
        afterFirstPaint(theme, client);
    });
    window.show();
    const int code = QApplication::exec();
    engine.shutdown();
    return code;
}
