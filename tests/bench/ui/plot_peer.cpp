#include <QVBoxLayout>

#include "qcustomplot.h"

#include "tests/bench/ui/plot_subject.h"

namespace kickstand::bench {
namespace {

double coordinateOf(TimePoint time) {
    return seconds(time.time_since_epoch());
}

/// Set up as quick as it can be made by its own switches: no antialiasing, pens of one pixel, cached labels,
/// opaque grids, and its adaptive sampling left on.
class PeerPlot final : public PlotSubject {
  public:
    explicit PeerPlot(QWidget* parent) : plot_(new QCustomPlot(parent)) {
        plot_->setNotAntialiasedElements(QCP::aeAll);
        plot_->setPlottingHints(QCP::phCacheLabels);
        plot_->plotLayout()->clear();
        for (int signal = 0; signal < kSignals; ++signal) {
            auto* rect = new QCPAxisRect(plot_, false);
            QCPAxis* time = rect->addAxis(QCPAxis::atBottom);
            QCPAxis* value = rect->addAxis(QCPAxis::atLeft);
            value->setRange(kLowest, kHighest);
            for (QCPAxis* axis : {time, value})
                axis->grid()->setPen(QPen(QColor(0xe6e9ed), 1));
            plot_->plotLayout()->addElement(signal, 0, rect);
            times_.push_back(time);
            for (int unit = 0; unit < kUnits; ++unit) {
                QCPGraph* graph = plot_->addGraph(time, value);
                graph->setPen(QPen(QColor::fromHsv(unit * 360 / kUnits, 255, 180), 1));
                graphs_.at(static_cast<std::size_t>(unit * kSignals + signal)) = graph;
            }
        }
        parent->layout()->addWidget(plot_);
    }

    QWidget& canvas() override { return *plot_; }
    void append(TimePoint time, const float* values) override {
        for (std::size_t i = 0; i < kSeries; ++i)
            graphs_[i]->addData(coordinateOf(time), static_cast<double>(values[i]));
    }
    void frame(TimePoint now) override {
        if (following_) end_ = coordinateOf(now);
        for (QCPAxis* axis : times_)
            axis->setRange(end_ - span_, end_);
        plot_->replot(QCustomPlot::rpQueuedRefresh);
    }
    void follow() override {
        following_ = true;
        span_ = seconds(kSpan);
    }
    void pan(double part) override {
        following_ = false;
        end_ += part * span_;
    }
    void zoom(double factor) override { span_ *= factor; }

  private:
    QCustomPlot* plot_;
    std::vector<QCPAxis*> times_;
    std::array<QCPGraph*, kSeries> graphs_{};
    double end_ = 0;
    double span_ = seconds(kSpan);
    bool following_ = true;
};

}  // namespace

std::unique_ptr<PlotSubject> makePeerPlot(QWidget* parent) {
    return std::make_unique<PeerPlot>(parent);
}

}  // namespace kickstand::bench
