#include "ui/motionplan/plan_path.h"

#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using motionplan::along;
using motionplan::Pose;

namespace {

constexpr int kArcPieces = 24;
constexpr double kMargin = 28;
constexpr std::array<double, 5> kGrids_cm{10, 50, 100, 500, 1000};
constexpr double kLeastGrid = 24;
constexpr double kLeastRobot = 14;
constexpr double kStepWidth = 2;
constexpr double kLitWidth = 5;
constexpr double kChosenWidth = 13;
constexpr double kChosenInside = 10;
constexpr QPointF kNumberPlace{9, -8};

}  // namespace

/// Centimetres to pixels.
struct PlanPath::View {
    double scale = 1;
    QPointF middle_cm;
    QPointF middle_px;

    QPointF map(double x_cm, double y_cm) const {
        return {middle_px.x() + (x_cm - middle_cm.x()) * scale,
                middle_px.y() - (y_cm - middle_cm.y()) * scale};
    }
    QPointF map(const Pose& pose) const { return map(pose.x_cm, pose.y_cm); }
};

PlanPath::PlanPath(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("planPath"));
    setAccessibleName(tr("The way of the plan, from above"));
    setMinimumSize(200, 160);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    replan();
}

QSize PlanPath::sizeHint() const {
    return {360, 260};
}

void PlanPath::replan() {
    corners_ = motionplan::corners(movements_, track_cm_);
    update();
}

void PlanPath::setPlan(const std::vector<motionplan::Movement>& movements) {
    movements_ = movements;
    replan();
}

void PlanPath::setTrack(double track_cm) {
    track_cm_ = track_cm;
    replan();
}

void PlanPath::setExecuting(int step, double done) {
    executing_ = step;
    done_ = done;
    update();
}

void PlanPath::setChosen(int step) {
    chosen_ = step;
    update();
}

PlanPath::View PlanPath::view() const {
    QRectF bounds(-track_cm_, -track_cm_, 2 * track_cm_, 2 * track_cm_);
    for (const Pose& pose : corners_)
        bounds |= QRectF(pose.x_cm - track_cm_, pose.y_cm - track_cm_, 2 * track_cm_, 2 * track_cm_);
    View view;
    view.middle_cm = bounds.center();
    view.middle_px = QRectF(rect()).center();
    view.scale = std::min(std::max(width() - 2 * kMargin, 1.0) / bounds.width(),
                          std::max(height() - 2 * kMargin, 1.0) / bounds.height());
    return view;
}

void PlanPath::drawGrid(QPainter& painter, const View& view) const {
    const Tokens& tokens = tokensOf(palette());
    const auto* const found = std::find_if(kGrids_cm.begin(), kGrids_cm.end(), [&view](double grid_cm) {
        return grid_cm * view.scale >= kLeastGrid;
    });
    const double grid_cm = found == kGrids_cm.end() ? kGrids_cm.back() : *found;
    const QPointF origin = view.map(0, 0);
    const double step = grid_cm * view.scale;
    painter.setPen(tokens.grid);
    for (double x = std::fmod(origin.x(), step); x < width(); x += step)
        painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    for (double y = std::fmod(origin.y(), step); y < height(); y += step)
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    painter.setPen(tokens.muted);
    painter.setFont(textFont(metrics::kSmallTextSize));
    painter.drawText(rect().adjusted(metrics::kGap, 0, -metrics::kGap, -4), Qt::AlignLeft | Qt::AlignBottom,
                     tr("grid %1 cm").arg(grid_cm));
}

QPainterPath PlanPath::stepLine(std::size_t step, const View& view) const {
    QPainterPath path(view.map(corners_[step]));
    for (int piece = 1; piece <= kArcPieces; ++piece)
        path.lineTo(view.map(
            along(corners_[step], movements_[step], static_cast<double>(piece) / kArcPieces, track_cm_)));
    return path;
}

void PlanPath::drawSteps(QPainter& painter, const View& view) const {
    const Tokens& tokens = tokensOf(palette());
    const auto draw = [&](std::size_t step, const QColor& colour, double width) {
        painter.strokePath(stepLine(step, view),
                           QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    };
    // The chosen step has a line around it, so that it is told from the one that executes.
    if (chosen_ >= 0 && chosen_ < static_cast<int>(movements_.size())) {
        draw(static_cast<std::size_t>(chosen_), tokens.muted, kChosenWidth);
        draw(static_cast<std::size_t>(chosen_), tokens.surface, kChosenInside);
    }
    for (std::size_t i = 0; i < movements_.size(); ++i) {
        if (!isLit(i)) draw(i, tokens.text, kStepWidth);
    }
    // Last, because plans cross their own way.
    for (std::size_t i = 0; i < movements_.size(); ++i) {
        if (isLit(i)) draw(i, tokens.accent, kLitWidth);
    }
}

void PlanPath::drawNumbers(QPainter& painter, const View& view) const {
    const Tokens& tokens = tokensOf(palette());
    const QFont font = numberFont(metrics::kSmallTextSize);
    painter.setFont(font);
    for (std::size_t i = 0; i < movements_.size(); ++i) {
        const QString number = QString::number(i + 1);
        const QPointF place = view.map(along(corners_[i], movements_[i], 0.5, track_cm_)) + kNumberPlace;
        painter.setPen(tokens.muted);
        if (!isLit(i)) painter.drawText(place, number);
    }
    if (executing_ < 1 || executing_ > static_cast<int>(movements_.size())) return;
    const auto lit = static_cast<std::size_t>(executing_ - 1);
    const QString text = tr("\u25b6 %1").arg(executing_);
    QRectF chip(QPointF(), chipSize(text, font));
    chip.moveBottomLeft(view.map(along(corners_[lit], movements_[lit], 0.5, track_cm_)) + kNumberPlace);
    drawChip(painter, chip, text, font, tokens.accent, tokens.onAccent);
}

Pose PlanPath::robot() const {
    if (executing_ < 1 || executing_ > static_cast<int>(movements_.size())) return corners_.front();
    const auto step = static_cast<std::size_t>(executing_ - 1);
    return along(corners_[step], movements_[step], done_, track_cm_);
}

QPainterPath PlanPath::robotShape(const View& view) const {
    const double size = std::max(track_cm_ * view.scale, kLeastRobot);
    QPainterPath body;
    body.moveTo(0, -size * 0.7);
    body.lineTo(size / 2, -size * 0.2);
    body.lineTo(size / 2, size / 2);
    body.lineTo(-size / 2, size / 2);
    body.lineTo(-size / 2, -size * 0.2);
    body.closeSubpath();
    const Pose pose = robot();
    const QPointF place = view.map(pose);
    QTransform turned = QTransform::fromTranslate(place.x(), place.y());
    turned.rotate(-pose.heading_deg);
    return turned.map(body);
}

void PlanPath::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Tokens& tokens = tokensOf(palette());
    painter.fillRect(rect(), tokens.surface);
    const View seen = view();
    drawGrid(painter, seen);
    painter.setRenderHint(QPainter::Antialiasing);
    // The way over the robot's body, so that the step that it is on stays seen; its outline over the way.
    const bool runs = executing_ > 0;
    const QPainterPath body = robotShape(seen);
    painter.fillPath(body, runs ? tokens.accentSoft : tokens.surface);
    drawSteps(painter, seen);
    painter.strokePath(body, QPen(runs ? tokens.accent : tokens.muted, 2));
    drawNumbers(painter, seen);
}

}  // namespace kickstand::ui
