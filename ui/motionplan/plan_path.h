#pragma once

#include <QWidget>
#include <vector>

#include "core/motionplan/path.h"
#include "core/motionplan/plan.h"

class QPainterPath;

namespace kickstand::ui {

/// The way that a plan leads, drawn to scale from above: each step a line or an arc of the robot's middle,
/// the one that executes lit, and the robot where it is.
class PlanPath final : public QWidget {
    Q_OBJECT
  public:
    explicit PlanPath(QWidget* parent = nullptr);

    void setPlan(const std::vector<motionplan::Movement>& movements);
    void setTrack(double track_cm);
    /// The step that executes, from 1, and how much of it is thought to be done (0-1); 0 for none.
    void setExecuting(int step, double done);
    /// The step that a person has chosen, from 0; -1 for none.
    void setChosen(int step);
    int executing() const { return executing_; }

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    struct View;
    View view() const;
    void drawGrid(QPainter& painter, const View& view) const;
    void drawSteps(QPainter& painter, const View& view) const;
    void drawNumbers(QPainter& painter, const View& view) const;
    QPainterPath robotShape(const View& view) const;
    QPainterPath stepLine(std::size_t step, const View& view) const;
    bool isLit(std::size_t step) const { return static_cast<int>(step) + 1 == executing_; }
    motionplan::Pose robot() const;
    void replan();

    std::vector<motionplan::Movement> movements_;
    std::vector<motionplan::Pose> corners_;
    double track_cm_ = motionplan::kTrackWidth_cm;
    int executing_ = 0;
    double done_ = 0;
    int chosen_ = -1;
};

}  // namespace kickstand::ui
