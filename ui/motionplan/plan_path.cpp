#include "ui/motionplan/plan_path.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using motionplan::along;
using motionplan::Pose;

namespace {

constexpr int kArcPieces = 24;
constexpr double kMargin = 28;
constexpr std::array<double, 5> kGrids_cm{10, 50, 100, 500, 1000};
constexpr double kLeastGrid = 24;

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

void PlanPath::drawSteps(QPainter& painter, const View& view) const {
    const Tokens& tokens = tokensOf(palette());
    for (std::size_t i = 0; i < movements_.size(); ++i) {
        QPainterPath path(view.map(corners_[i]));
        for (int piece = 1; piece <= kArcPieces; ++piece)
            path.lineTo(view.map(
                along(corners_[i], movements_[i], static_cast<double>(piece) / kArcPieces, track_cm_)));
        const bool lit = static_cast<int>(i) + 1 == executing_;
        const bool chosen = static_cast<int>(i) == chosen_;
        const QColor colour = lit || chosen ? tokens.accent : tokens.text;
        painter.setPen(QPen(colour, lit ? 5 : (chosen ? 3 : 2), Qt::SolidLine, Qt::RoundCap));
        painter.drawPath(path);
        painter.setPen(tokens.muted);
        painter.drawText(view.map(along(corners_[i], movements_[i], 0.5, track_cm_)) + QPointF(6, -4),
                         QString::number(i + 1));
    }
}

Pose PlanPath::robot() const {
    if (executing_ < 1 || executing_ > static_cast<int>(movements_.size())) return corners_.front();
    const auto step = static_cast<std::size_t>(executing_ - 1);
    return along(corners_[step], movements_[step], done_, track_cm_);
}

void PlanPath::drawRobot(QPainter& painter, const View& view, const Pose& pose) const {
    const Tokens& tokens = tokensOf(palette());
    const double size = std::max(track_cm_ * view.scale, 14.0);
    painter.save();
    painter.translate(view.map(pose));
    painter.rotate(-pose.heading_deg);
    painter.setPen(QPen(executing_ > 0 ? tokens.accent : tokens.muted, 2));
    painter.setBrush(executing_ > 0 ? tokens.accentSoft : tokens.surface);
    QPainterPath body;
    body.moveTo(0, -size * 0.7);
    body.lineTo(size / 2, -size * 0.2);
    body.lineTo(size / 2, size / 2);
    body.lineTo(-size / 2, size / 2);
    body.lineTo(-size / 2, -size * 0.2);
    body.closeSubpath();
    painter.drawPath(body);
    painter.restore();
}

void PlanPath::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), tokensOf(palette()).surface);
    const View seen = view();
    drawGrid(painter, seen);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(numberFont(metrics::kSmallTextSize));
    drawSteps(painter, seen);
    drawRobot(painter, seen, robot());
}

}  // namespace kickstand::ui
