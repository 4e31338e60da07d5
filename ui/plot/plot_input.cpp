#include "ui/plot/plot_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>

#include "ui/plot/plot_scene.h"
#include "ui/plot/time_plot.h"
#include "ui/plot/time_ticks.h"

namespace kickstand::ui {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kNotch = 120;
/// Keys move by this part of what is seen.
constexpr double kKeyPart = 0.1;
constexpr int kFastColumns = 10;
constexpr double kCursorReach = 5;

}  // namespace

PlotInput::PlotInput(TimePlot& plot, QCustomPlot& canvas) : QObject(&plot), plot_(plot), canvas_(canvas) {
    canvas.installEventFilter(this);
}

bool PlotInput::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            drag_ = Drag::None;
            canvas_.unsetCursor();
            return true;
        case QEvent::MouseButtonDblClick:
            plot_.follow();
            return true;
        case QEvent::Wheel:
            return wheel(*static_cast<QWheelEvent*>(event));
        case QEvent::KeyPress:
            return key(*static_cast<QKeyEvent*>(event));
        default:
            return QObject::eventFilter(watched, event);
    }
}

double PlotInput::placeOf(double x) const {
    const TimeView& view = plot_.state().view;
    return std::clamp(view.placeOf(plot_.scene().geometry().timeAt(view, x)), 0.0, 1.0);
}

bool PlotInput::press(const QMouseEvent& event) {
    const PlotGeometry geometry = plot_.scene().geometry();
    if (event.button() != Qt::LeftButton || geometry.empty()) return false;
    canvas_.setFocus(Qt::MouseFocusReason);
    const TimeView& view = plot_.state().view;
    last_ = event.position();
    rest_ = 0;
    area_ = geometry.areaAt(last_.y());
    plot_.chooseKeyArea(area_);
    const TimePoint time = geometry.timeAt(view, last_.x());
    const Duration reach = geometry.timeAt(view, last_.x() + kCursorReach) - geometry.timeAt(view, last_.x());
    cursor_ = plot_.state().cursors.nearest(time, reach);
    drag_ = cursor_ >= 0                                      ? Drag::Cursor
            : event.modifiers().testFlag(Qt::ControlModifier) ? Drag::Values
                                                              : Drag::Time;
    if (drag_ == Drag::Cursor) plot_.putCursor(cursor_, time);
    return true;
}

bool PlotInput::move(const QMouseEvent& event) {
    const PlotGeometry geometry = plot_.scene().geometry();
    if (geometry.empty()) return false;
    const QPointF by = event.position() - last_;
    const QRect area = geometry.areas[static_cast<std::size_t>(area_)];
    if (drag_ == Drag::None || area.isEmpty()) {
        hover(event.position());
        return true;
    }
    const TimeView& view = plot_.state().view;
    last_ = event.position();
    if (drag_ == Drag::Cursor) {
        plot_.putCursor(cursor_, view.timeAt(placeOf(last_.x())));
    } else if (drag_ == Drag::Values) {
        plot_.panValues(area_, by.y() / area.height());
    } else {
        rest_ -= by.x() * view.columns() / area.width();
        const double whole = std::trunc(rest_);
        rest_ -= whole;
        if (whole != 0) plot_.panTime(static_cast<std::int64_t>(whole));
    }
    canvas_.setCursor(drag_ == Drag::Cursor ? Qt::SizeHorCursor : Qt::ClosedHandCursor);
    return true;
}

void PlotInput::hover(const QPointF& at) {
    const PlotGeometry geometry = plot_.scene().geometry();
    const auto mark = markNear(plot_.state(), geometry, at.x());
    const auto words = mark ? plot_.state().describeMark(*mark) : std::nullopt;
    if (!words) {
        QToolTip::hideText();
        return;
    }
    const QString clock = clockText(plot_.state().clock.wall(mark->time));
    QToolTip::showText(canvas_.mapToGlobal(at.toPoint()), clock + QStringLiteral("\n") + words->words,
                       &canvas_);
}

bool PlotInput::wheel(const QWheelEvent& event) {
    const PlotGeometry geometry = plot_.scene().geometry();
    if (geometry.empty()) return false;
    const QPoint turned = event.angleDelta();
    if (turned.x() != 0 && std::abs(turned.x()) > std::abs(turned.y())) {
        const double part = -turned.x() / kNotch * kKeyPart;
        plot_.panTime(std::lround(part * plot_.state().view.columns()));
        return true;
    }
    const double factor = std::pow(kZoomStep, -turned.y() / kNotch);
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        const int area = geometry.areaAt(event.position().y());
        const ValueRange& range = plot_.state().areas[static_cast<std::size_t>(area)].range;
        const QRect& rect = geometry.areas[static_cast<std::size_t>(area)];
        const double part = (event.position().y() - rect.top()) / std::max(rect.height(), 1);
        plot_.zoomValues(area, factor, range.high - std::clamp(part, 0.0, 1.0) * range.size());
    } else {
        plot_.zoomTime(factor, placeOf(event.position().x()));
    }
    return true;
}

bool PlotInput::key(const QKeyEvent& event) {
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    if (event.modifiers().testFlag(Qt::AltModifier) || plot_.state().areas.empty()) return false;
    if (valueKey(event.key(), control)) return true;
    if (shift && cursorKey(event.key(), control)) return true;
    if (control) return false;
    const auto part = static_cast<std::int64_t>(plot_.state().view.columns() * kKeyPart) + 1;
    switch (event.key()) {
        case Qt::Key_Left:
            plot_.panTime(-part);
            return true;
        case Qt::Key_Right:
            plot_.panTime(part);
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            plot_.zoomTime(1 / kZoomStep, 0.5);
            return true;
        case Qt::Key_Minus:
            plot_.zoomTime(kZoomStep, 0.5);
            return true;
        case Qt::Key_Home:
            plot_.showOldest();
            return true;
        case Qt::Key_End:
        case Qt::Key_F:
            plot_.follow();
            return true;
        case Qt::Key_P:
            plot_.isFollowing() ? plot_.pause() : plot_.follow();
            return true;
        case Qt::Key_C:
            plot_.showCursors(!plot_.state().cursors.isShown());
            return true;
        case Qt::Key_X:
            plot_.swapCursors();
            return true;
        case Qt::Key_M:
            goToMark(!shift);
            return true;
        default:
            return false;
    }
}

bool PlotInput::valueKey(int key, bool control) {
    const int area = plot_.state().keyArea;
    const ValueRange& range = plot_.state().areas[static_cast<std::size_t>(area)].range;
    const double middle = (range.low + range.high) / 2;
    switch (key) {
        case Qt::Key_Up:
            plot_.panValues(area, kKeyPart);
            return true;
        case Qt::Key_Down:
            plot_.panValues(area, -kKeyPart);
            return true;
        case Qt::Key_PageUp:
            plot_.chooseKeyArea(area - 1);
            return true;
        case Qt::Key_PageDown:
            plot_.chooseKeyArea(area + 1);
            return true;
        case Qt::Key_V:
            plot_.fitValues();
            return true;
        case Qt::Key_U:
            plot_.usualValues();
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            if (control) plot_.zoomValues(area, 1 / kZoomStep, middle);
            return control;
        case Qt::Key_Minus:
            if (control) plot_.zoomValues(area, kZoomStep, middle);
            return control;
        default:
            return false;
    }
}

bool PlotInput::cursorKey(int key, bool fast) {
    if (key != Qt::Key_Left && key != Qt::Key_Right) return false;
    const int columns = (fast ? kFastColumns : 1) * (key == Qt::Key_Left ? -1 : 1);
    plot_.stepCursor(columns);
    return true;
}

void PlotInput::goToMark(bool next) {
    if (!plot_.goToMark(next)) return;
    const PlotState& state = plot_.state();
    const std::int64_t middle = state.view.middle();
    const Duration width = state.view.columnWidth();
    const auto marks = state.store->marks().between(startOf(middle, width), startOf(middle + 1, width));
    for (const Mark& mark : marks.value_or(std::vector<Mark>{})) {
        const auto words = state.describeMark(mark);
        if (!words) continue;
        const QString text = clockText(state.clock.wall(mark.time)) + QStringLiteral("\n") + words->words;
        canvas_.setAccessibleDescription(text);
        QToolTip::showText(canvas_.mapToGlobal(QPoint(canvas_.width() / 2, 0)), text, &canvas_);
        return;
    }
}

}  // namespace kickstand::ui
