// The window as it stands on a bench for an hour: sixteen simulated robots on an ideal radio, 200 readings a
// second each, all plotted while a person kicks, drives, looks through the panels and comes back. Every frame
// of the plot is timed, and memory is looked at every minute. Prints one JSON object; exits 1 when a frame
// came later than 50 ms, when memory grew after the rings were full, or when something was stopped. For each
// late frame it says how long the window's thread was at work meanwhile: where that is short, the machine was
// with somebody else.
//
//     window [MINUTES]

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "app/composition/composition.h"
#include "core/engine/engine.h"
#include "core/ledger/ledger.h"
#include "tests/soak/memory.h"
#include "ui/plot/time_plot.h"
#include "ui/shell/bench.h"
#include "ui/shell/connector.h"
#include "ui/shell/main_window.h"
#include "ui/shell/system_view.h"
#include "ui/shell/theme.h"
#include "ui/thunderbots/thunderbots_view.h"

namespace {

using namespace kickstand;
using namespace thunderbots;

constexpr QSize kSize(1920, 1080);
constexpr double kDefaultMinutes = 60;
constexpr double kLatest_ms = 50;
/// What memory may grow by once the telemetry's rings, which take theirs as they fill, are left out.
constexpr double kMayGrow_MB = 16;
constexpr int kBeat_ms = 5'000;
constexpr int kMinute_ms = 60'000;
/// Connecting, laying out and the first pictures of every panel are not what this is about.
constexpr int kWarmUp_ms = 20'000;

/// The time that this thread has been at work.
double worked_ms() {
    timespec worked{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
    return static_cast<double>(worked.tv_sec) * 1e3 + static_cast<double>(worked.tv_nsec) / 1e6;
}

struct LateFrame {
    double at_s;
    double took_ms;
    double worked_ms;
};

/// Times the paint events of a widget that has something new to show on every frame.
class FrameWatch final : public QObject {
  public:
    using QObject::QObject;

    void begin() {
        sinceBegin_.start();
        sincePaint_.start();
        worked_ms_ = worked_ms();
    }
    const std::vector<double>& frames_ms() const { return frames_ms_; }
    const std::vector<LateFrame>& late() const { return late_; }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && sincePaint_.isValid()) {
            const double took_ms = static_cast<double>(sincePaint_.nsecsElapsed()) / 1e6;
            const double worked = worked_ms();
            frames_ms_.push_back(took_ms);
            if (took_ms > kLatest_ms) {
                late_.push_back(
                    {static_cast<double>(sinceBegin_.elapsed()) / 1e3, took_ms, worked - worked_ms_});
            }
            worked_ms_ = worked;
            sincePaint_.restart();
        }
        return QObject::eventFilter(watched, event);
    }

  private:
    QElapsedTimer sinceBegin_;
    QElapsedTimer sincePaint_;
    double worked_ms_ = 0;
    std::vector<double> frames_ms_;
    std::vector<LateFrame> late_;
};

class WindowHour final : public QObject {
  public:
    explicit WindowHour(double minutes);
    int run();

  private:
    void beat();
    void look();
    int report();
    double ownMemory_MB() const { return soak::resident_MB() - soak::rings_MB(client_.snapshot()); }

    const double minutes_;
    QTemporaryDir folder_;
    QSettings settings_;
    ui::Theme theme_;
    Engine engine_;
    ui::EngineClient client_;
    Ledger ledger_{":memory:"};
    ui::SystemRegistry systems_;
    ui::ThunderbotsView* view_ = nullptr;
    ui::Bench bench_;
    std::unique_ptr<ui::MainWindow> window_;
    FrameWatch frames_;
    std::vector<double> memory_MB_;
    std::vector<double> resident_MB_;
    std::uint64_t beats_ = 0;
    std::uint64_t kicks_ = 0;
    std::uint64_t eventsLost_ = 0;
    std::uint64_t stops_ = 0;
};

WindowHour::WindowHour(double minutes)
    : minutes_(minutes),
      settings_(folder_.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat),
      theme_(settings_),
      engine_(makeLinkProvider()),
      client_(engine_),
      bench_(client_, systems_, settings_) {
    auto view = std::make_unique<ui::ThunderbotsView>(ledger_);
    view_ = view.get();
    systems_.add(std::move(view));
    window_ = std::make_unique<ui::MainWindow>(bench_, theme_);
    connect(&client_, &ui::EngineClient::eventsArrived, this,
            [this](const std::vector<EngineEvent>&, quint64 lost) { eventsLost_ += lost; });
    connect(&client_, &ui::EngineClient::stopChanged, this, [this] { ++stops_; });
}

int WindowHour::run() {
    window_->resize(kSize);
    window_->show();
    window_->connector().connectTo(*parseLinkUri("sim:thunderbots?radio=ideal"));
    for (QWidget* part : window_->findChild<ui::TimePlot*>()->findChildren<QWidget*>()) {
        if (part->inherits("QCustomPlot")) part->installEventFilter(&frames_);
    }

    QTimer beats;
    connect(&beats, &QTimer::timeout, this, &WindowHour::beat);
    beats.start(kBeat_ms);
    QTimer minutes;
    connect(&minutes, &QTimer::timeout, this, &WindowHour::look);
    QTimer::singleShot(kWarmUp_ms, this, [this, &minutes] {
        frames_.begin();
        look();
        minutes.start(kMinute_ms);
    });
    // Not quit(), which the window refuses while capacitors are live.
    QTimer::singleShot(kWarmUp_ms + static_cast<int>(minutes_ * kMinute_ms) + kBeat_ms, this,
                       [] { QCoreApplication::exit(); });
    QApplication::exec();
    const int code = report();
    window_.reset();
    engine_.shutdown();
    return code;
}

void WindowHour::beat() {
    // All robots are looked at and driven, one after another kicks, and panels beside the plot are leafed
    // through.
    if (beats_ == 0) {
        view_->choice().choose(kAllRobots);
        bench_.submit(SystemCommand(thunderbots::Command(ArmHighVoltage{kAllRobots, true})));
        bench_.submit(SystemCommand(thunderbots::Command(SetCharger{kAllRobots, true})));
        return void(++beats_);
    }
    const auto robot = static_cast<int>(beats_ % kRobots);
    bench_.submit(SystemCommand(thunderbots::Command(Kick{robot, {true, true, 60, 0, 0}})), this,
                  [this](const Result<void>& result) { kicks_ += result ? 1 : 0; });
    const std::int16_t speed = beats_ % 2 == 0 ? 60 : -60;
    bench_.submit(SystemCommand(thunderbots::Command(SetWheels{kAllRobots, {speed, speed, speed, speed}})));
    static const std::vector<QString> kPanels{QStringLiteral("drive"),      QStringLiteral("kick"),
                                              QStringLiteral("faults"),     QStringLiteral("gamepad"),
                                              QStringLiteral("experiment"), QStringLiteral("leds"),
                                              QStringLiteral("simulated")};
    bench_.goTo(kPanels[beats_ % kPanels.size()]);
    ++beats_;
}

void WindowHour::look() {
    memory_MB_.push_back(ownMemory_MB());
    resident_MB_.push_back(soak::resident_MB());
}

int WindowHour::report() {
    std::vector<double> frames = frames_.frames_ms();
    if (frames.empty() || memory_MB_.empty()) {
        std::fputs("window: the plot was never painted\n", stderr);
        return 1;
    }
    std::string lateOnes;
    for (const LateFrame& late : frames_.late()) {
        lateOnes += QStringLiteral("%1{\"at_s\":%2,\"took_ms\":%3,\"worked_ms\":%4}")
                        .arg(lateOnes.empty() ? QString() : QStringLiteral(","))
                        .arg(late.at_s, 0, 'f', 1)
                        .arg(late.took_ms, 0, 'f', 1)
                        .arg(late.worked_ms, 0, 'f', 1)
                        .toStdString();
    }
    std::sort(frames.begin(), frames.end());
    const auto at = [&frames](double share) {
        return frames[static_cast<std::size_t>(share * static_cast<double>(frames.size() - 1))];
    };
    const std::size_t late = frames_.late().size();
    const double grown = memory_MB_.back() - memory_MB_[memory_MB_.size() / 4];
    const bool good = late == 0 && grown <= kMayGrow_MB && stops_ == 0 && eventsLost_ == 0;
    std::printf(
        "{\"minutes\":%.1f,\"frames\":%zu,\"frame_ms\":{\"p50\":%.1f,\"p99\":%.1f,\"max\":%.1f},"
        "\"later_than_50_ms\":%zu,\"late\":[%s],\"kicks\":%llu,\"stops\":%llu,\"events_lost\":%llu,"
        "\"memory_MB\":{\"start\":%.1f,\"quarter\":%.1f,\"end\":%.1f},"
        "\"resident_MB\":{\"start\":%.1f,\"quarter\":%.1f,\"end\":%.1f},\"good\":%s}\n",
        minutes_, frames.size(), at(0.5), at(0.99), frames.back(), late, lateOnes.c_str(),
        static_cast<unsigned long long>(kicks_), static_cast<unsigned long long>(stops_),
        static_cast<unsigned long long>(eventsLost_), memory_MB_.front(), memory_MB_[memory_MB_.size() / 4],
        memory_MB_.back(), resident_MB_.front(), resident_MB_[resident_MB_.size() / 4], resident_MB_.back(),
        good ? "true" : "false");
    return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName(QStringLiteral("kickstand-soak"));
    QApplication application(argc, argv);
    const double minutes = argc > 1 ? std::atof(argv[1]) : kDefaultMinutes;
    if (minutes <= 0) {
        std::fputs("usage: window [MINUTES]\n", stderr);
        return 2;
    }
    return WindowHour(minutes).run();
}
