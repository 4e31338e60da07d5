#include <QVBoxLayout>

#include "tests/bench/ui/plot_subject.h"
#include "ui/plot/plot_scene.h"
#include "ui/plot/time_plot.h"

namespace kickstand::bench {
namespace {

/// Two seconds: three hundred marks are seen at a time.
constexpr int kMarkEvery = 400;
constexpr int kMarkKinds = static_cast<int>(MarkKind::UnitLost) + 1;

class OwnPlot final : public PlotSubject {
  public:
    explicit OwnPlot(QWidget* parent)
        : store_(std::make_shared<TelemetryStore>()),
          plot_(new ui::TimePlot(
              {[this] { return now_; }, [](TimePoint) { return std::chrono::system_clock::now(); }},
              parent)) {
        std::vector<ui::PlotArea> areas;
        std::vector<ui::PlotCurve> curves;
        for (int signal = 0; signal < kSignals; ++signal) {
            areas.push_back({QString::number(signal),
                             {},
                             0,
                             {kLowest, kHighest},
                             {{kHighest / 2, QStringLiteral("a threshold")}}});
            for (int unit = 0; unit < kUnits; ++unit) {
                const SignalId id{static_cast<std::uint16_t>(unit), static_cast<std::uint16_t>(signal)};
                series_[static_cast<std::size_t>(unit * kSignals + signal)] = store_->series(id);
                curves.push_back({id, signal, QString::number(unit), QString::number(unit), unit % 7});
            }
        }
        plot_->setStore(store_);
        plot_->setContents(areas, std::move(curves));
        plot_->setSpan(kSpan);
        plot_->setDescribeMark([](const Mark& mark) {
            const auto tone = mark.kind == MarkKind::Stop ? ui::MarkTone::Danger : ui::MarkTone::Plain;
            return std::optional(ui::MarkWords{QStringLiteral("mark %1").arg(mark.unit), {}, tone});
        });
        parent->layout()->addWidget(plot_);
    }

    QWidget& canvas() override { return plot_->canvas(); }
    void append(TimePoint time, const float* values) override {
        for (std::size_t i = 0; i < kSeries; ++i)
            series_[i]->append(time, values[i]);
        if (++ticks_ % kMarkEvery != 0) return;
        const int mark = ticks_ / kMarkEvery;
        store_->mark(
            {time, static_cast<MarkKind>(mark % kMarkKinds), static_cast<std::uint16_t>(mark % kUnits), 0});
    }
    /// It draws by itself, as often as it finds something new.
    void frame(TimePoint now) override { now_ = now; }
    void follow() override {
        plot_->setSpan(kSpan);
        plot_->follow();
    }
    void pan(double part) override {
        plot_->panTime(static_cast<std::int64_t>(part * plot_->state().view.columns()));
    }
    void zoom(double factor) override { plot_->zoomTime(factor, 0.5); }

  private:
    std::shared_ptr<TelemetryStore> store_;
    std::array<TimeSeries*, kSeries> series_{};
    TimePoint now_{};
    int ticks_ = 0;
    ui::TimePlot* plot_;
};

}  // namespace

std::unique_ptr<PlotSubject> makeOwnPlot(QWidget* parent) {
    return std::make_unique<OwnPlot>(parent);
}

}  // namespace kickstand::bench
