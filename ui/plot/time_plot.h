#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "core/telemetry/sample.h"
#include "ui/plot/plot_state.h"
#include "ui/plot/seen_csv.h"

class QCustomPlot;

namespace kickstand::ui {

class PlotScene;

/// Live curves over time, drawn from a telemetry store while it is written. Pausing, zooming and panning
/// change what is seen and never what is recorded. GUI thread.
class TimePlot final : public QWidget {
    Q_OBJECT
  public:
    explicit TimePlot(PlotClock clock, QWidget* parent = nullptr);
    ~TimePlot() override;

    /// What is drawn from; null for nothing.
    void setStore(std::shared_ptr<const TelemetryStore> store);
    /// What is drawn of it. Areas that stay the same keep the range that a person chose.
    void setContents(const std::vector<PlotArea>& areas, std::vector<PlotCurve> curves);
    /// How marks are told: one, and several of a kind together.
    void setDescribeMark(DescribeMark describe, CountMarks count = {});

    const PlotState& state() const { return *state_; }
    bool isFollowing() const { return state_->view.isFollowing(); }
    void follow();
    void pause();
    void setSpan(Duration span);
    /// As TimeView has them.
    void zoomTime(double factor, double place);
    void panTime(std::int64_t columns);
    void showOldest();

    /// Of one area: what is at `value` stays.
    void zoomValues(int area, double factor, double value);
    /// Upwards by a part of what is seen.
    void panValues(int area, double part);
    /// Each area shows what lies in the visible span and no more.
    void fitValues();
    /// Each area shows its usual range.
    void usualValues();
    void chooseKeyArea(int area);

    void showCursors(bool shown);
    void putCursor(int cursor, TimePoint time);
    void stepCursor(std::int64_t columns);
    void swapCursors();

    /// Waits for a crossing of a level, and then stands still with it in the middle; data go on arriving.
    /// Replaces what was waited for.
    void arm(SignalId signal, Edge edge, double level);
    void disarm();

    /// Goes to the mark after (or before) the middle of the view and says what it is; false where there is
    /// none.
    bool goToMark(bool next);

    std::optional<SpanStats> statsOf(const PlotCurve& curve) const;
    std::optional<float> valueAt(const PlotCurve& curve, TimePoint time) const;
    /// What is seen, as a picture and as numbers.
    QPixmap picture();
    Seen seen() const;

    /// Draws now if anything has changed since it was last drawn; it does so by itself while it is visible.
    void frame();
    QCustomPlot& canvas() { return *canvas_; }
    const PlotScene& scene() const { return *scene_; }

    QSize sizeHint() const override { return {640, 220}; }
    QSize minimumSizeHint() const override { return {280, 120}; }

  signals:
    /// Something of the view has changed: following, span, ranges, cursors, trigger.
    void viewChanged();
    /// The trigger's level was crossed.
    void triggered();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    struct Drawn {
        ColumnSpan shown;
        Duration width{};
        std::int64_t present = 0;
        std::uint64_t samples = 0;
        std::uint64_t marks = 0;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };

    void changed();
    void checkTrigger();
    void widenUsual();
    Drawn current() const;

    std::unique_ptr<PlotState> state_;
    QCustomPlot* canvas_;
    std::unique_ptr<PlotScene> scene_;
    std::optional<Trigger> waiting_;
    Drawn drawn_;
    bool dirty_ = true;
    QTimer frames_;
    QTimer ranges_;
};

}  // namespace kickstand::ui
