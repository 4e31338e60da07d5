// Live plots of sixteen robots with five signals each at 200 Hz, ten minutes on screen (9.6 million points):
// frames a second and what they cost, beside plain QCustomPlot with all data, in the same run. Prints JSON.
// QT_QPA_PLATFORM chooses the screen; without a display it must be "offscreen".

#include <QApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <QVBoxLayout>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

#include "tests/bench/thunderbots/figures.h"
#include "tests/bench/ui/plot_subject.h"

namespace kickstand::bench {
namespace {

using namespace std::chrono_literals;

constexpr QSize kSize(1184, 760);
/// More than the telemetry's rings hold: they are full when measuring begins.
constexpr int kHistory = 660 * 200;
constexpr auto kWarmUp = 1s;
constexpr auto kMeasured = 6s;
constexpr int kTurnEvery = 60;
constexpr double kPanPart = 0.006;
constexpr double kZoomFactor = 1.02;

double processorTime_s() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto sum = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return sum(usage.ru_utime) + sum(usage.ru_stime);
}

double residentMemory_MB() {
    std::ifstream file("/proc/self/statm");
    double total = 0;
    double resident = 0;
    file >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Noise that never repeats the value before.
void fillValues(int tick, std::array<float, kSeries>& values) {
    for (std::size_t i = 0; i < kSeries; ++i) {
        const auto mixed =
            (static_cast<std::uint32_t>(tick) * 2654435761U) ^ (static_cast<std::uint32_t>(i) * 40503U);
        values[i] = static_cast<float>(mixed >> 23) + static_cast<float>(i / kSignals) * 32.0F +
                    static_cast<float>(tick & 1) / 2;
    }
}

/// Feeds a plot at 200 Hz of the clock on the wall, and counts its frames.
class Run final : public QObject {
  public:
    explicit Run(PlotSubject& subject) : subject_(subject) {
        for (; tick_ < kHistory; ++tick_)
            append();
        subject_.canvas().installEventFilter(this);
        clock_.start();
    }

    /// Does `act` before each of the frames, of which one is asked for every 16 ms.
    void measure(const char* name, const std::function<void(int)>& act, const char* end) {
        subject_.follow();
        spin(kWarmUp, act);
        intervals_ms_.clear();
        painted_ = 0;
        const double before_s = processorTime_s();
        QElapsedTimer watch;
        watch.start();
        spin(kMeasured, act);
        const double took_s = static_cast<double>(watch.nsecsElapsed()) / 1e9;
        const double cost = (processorTime_s() - before_s) / took_s * 100;
        std::printf(
            "    \"%s\": {\"frames_per_s\": %.1f, \"core_percent\": %.1f, \"longest_frame_ms\": %.1f}%s\n",
            name, painted_ / took_s, cost, intervals_ms_.empty() ? 0.0 : quantile(intervals_ms_, 1), end);
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            const double now_ms = static_cast<double>(clock_.nsecsElapsed()) / 1e6;
            if (painted_++ > 0) intervals_ms_.push_back(now_ms - paintedAt_ms_);
            paintedAt_ms_ = now_ms;
        }
        return QObject::eventFilter(watched, event);
    }

  private:
    void append() {
        fillValues(tick_, values_);
        subject_.append(TimePoint(kTick * tick_), values_.data());
    }
    TimePoint catchUp() {
        const TimePoint now(kTick * kHistory + std::chrono::nanoseconds(clock_.nsecsElapsed()));
        for (; TimePoint(kTick * tick_) <= now; ++tick_)
            append();
        return now;
    }
    void spin(std::chrono::milliseconds time, const std::function<void(int)>& act) {
        QEventLoop loop;
        QTimer feed;
        QTimer frames;
        feed.setTimerType(Qt::PreciseTimer);
        frames.setTimerType(Qt::PreciseTimer);
        connect(&feed, &QTimer::timeout, this, [this] { catchUp(); });
        connect(&frames, &QTimer::timeout, this, [this, &act] {
            if (act) act(frame_++);
            subject_.frame(catchUp());
        });
        QTimer::singleShot(time, Qt::PreciseTimer, &loop, &QEventLoop::quit);
        feed.start(5ms);
        frames.start(16ms);
        loop.exec();
    }

    PlotSubject& subject_;
    std::array<float, kSeries> values_{};
    int tick_ = 0;
    int frame_ = 0;
    int painted_ = 0;
    double paintedAt_ms_ = 0;
    std::vector<double> intervals_ms_;
    QElapsedTimer clock_;
};

void measure(const char* name, std::unique_ptr<PlotSubject> (*make)(QWidget*), const char* end) {
    QWidget window;
    new QVBoxLayout(&window);
    const double before_MB = residentMemory_MB();
    const std::unique_ptr<PlotSubject> subject = make(&window);
    Run run(*subject);
    window.resize(kSize);
    window.show();
    const auto back = [](int frame) { return frame / kTurnEvery % 2 == 0 ? 1 : -1; };
    std::printf("  \"%s\": {\n", name);
    run.measure("following", {}, ",");
    const double full_MB = residentMemory_MB();
    run.measure(
        "panning", [&](int frame) { subject->pan(-kPanPart * back(frame)); }, ",");
    run.measure(
        "zooming", [&](int frame) { subject->zoom(back(frame) > 0 ? 1 / kZoomFactor : kZoomFactor); }, ",");
    std::printf("    \"memory_MB\": %.1f,\n    \"memory_grown_MB\": %.1f\n  }%s\n", full_MB - before_MB,
                residentMemory_MB() - full_MB, end);
}

}  // namespace
}  // namespace kickstand::bench

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    std::printf("{\n");
    kickstand::bench::measure("own", kickstand::bench::makeOwnPlot, ",");
    kickstand::bench::measure("qcustomplot", kickstand::bench::makePeerPlot, "");
    std::printf("}\n");
    return 0;
}
