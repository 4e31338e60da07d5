#include "ui/thunderbots/body_box.h"

#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

/// Set points are hundredths of m/s and of rad/s.
constexpr int kDecimals = 2;
constexpr double kStep = 0.01;

int steps(double value) {
    return static_cast<int>(std::lround(value / kStep));
}

int wholeSteps(double most) {
    return static_cast<int>(std::floor(most / kStep));
}

QString wheelsText(const WheelSpeeds& wheels) {
    QStringList numbers;
    for (const int speed : wheels)
        numbers << signedNumber(speed);
    return numbers.join(QStringLiteral("  "));
}

}  // namespace

BodyBox::BodyBox(QWidget* parent) : QWidget(parent), made_(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);
    const std::array names = {tr("x forward"), tr("y left"), tr("rotation")};
    const std::array units = {tr("m/s"), tr("m/s"), tr("rad/s")};
    const std::array objects = {QStringLiteral("bodyX"), QStringLiteral("bodyY"), QStringLiteral("bodyTurn")};
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        axes_[i] = new SetPointSlider(names[i], this);
        axes_[i]->setObjectName(objects[i]);
        axes_[i]->setDecimals(kDecimals);
        axes_[i]->setMeaning(units[i]);
        connect(axes_[i], &SetPointSlider::asked, this, [this](int, bool held) { axisAsked(held); });
        column->addWidget(axes_[i]);
    }
    axes_[2]->setToolTip(tr("Counter-clockwise, seen from above"));
    made_->setObjectName(QStringLiteral("madeWheels"));
    made_->setFont(numberFont(metrics::kTextSize));
    made_->setMinimumHeight(metrics::kFieldHeight);
    made_->setWordWrap(true);
    column->addWidget(made_);
}

void BodyBox::showState(const WheelSpeeds& wheels, int limit, bool follow, bool differ) {
    if (limit != limit_) {
        limit_ = limit;
        const BodyMotion most = fastestMotion(limit);
        axes_[0]->setLimit(wholeSteps(most.x_m_per_s));
        axes_[1]->setLimit(wholeSteps(most.y_m_per_s));
        axes_[2]->setLimit(wholeSteps(most.turn_rad_per_s));
    }
    // The numbers that a person asked for stay, and not what their rounded wheels come to.
    if (follow && wheelsOf(motion_, limit).wheels != wheels) motion_ = motionOf(wheels);
    if (follow) showMotion();
    showWheels(wheels, differ);
}

void BodyBox::showMotion() {
    axes_[0]->showValue(steps(motion_.x_m_per_s));
    axes_[1]->showValue(steps(motion_.y_m_per_s));
    axes_[2]->showValue(steps(motion_.turn_rad_per_s));
}

void BodyBox::showWheels(const WheelSpeeds& wheels, bool differ) {
    const double scale = wheelsOf(motion_, limit_).scale;
    QString text = differ ? tr("wheels: each robot its own") : tr("wheels  %1").arg(wheelsText(wheels));
    if (!differ && scale < 1)
        text += tr("   slowed to %1 %: \u00b1%2").arg(std::floor(scale * 100), 0, 'f', 0).arg(limit_);
    made_->setText(text);
    made_->setToolTip(
        scale < 1
            ? tr("No wheel may be faster than \u00b1%1: the motion keeps its direction and is slowed down "
                 "to x %2, y %3 m/s, rotation %4 rad/s.")
                  .arg(limit_)
                  .arg(motion_.x_m_per_s * scale, 0, 'f', 2)
                  .arg(motion_.y_m_per_s * scale, 0, 'f', 2)
                  .arg(motion_.turn_rad_per_s * scale, 0, 'f', 2)
            : tr("Wheels 1 to 4: what the motion makes"));
}

void BodyBox::axisAsked(bool held) {
    motion_ = {axes_[0]->value() * kStep, axes_[1]->value() * kStep, axes_[2]->value() * kStep};
    emit asked(motion_, held);
}

void BodyBox::reset() {
    motion_ = {};
    for (SetPointSlider* axis : axes_)
        axis->reset();
}

void BodyBox::setReleaseToZero(bool on) {
    for (SetPointSlider* axis : axes_)
        axis->setReleaseToZero(on);
}

}  // namespace kickstand::ui
