#pragma once

#include <QWidget>
#include <array>

#include "ui/thunderbots/body_motion.h"

class QLabel;

namespace kickstand::ui {

class SetPointSlider;

/// How the body is to move, along its three ways, and the wheels that it makes. It shows and asks.
class BodyBox final : public QWidget {
    Q_OBJECT
  public:
    explicit BodyBox(QWidget* parent = nullptr);

    /// `follow`: whether the set points may follow these wheels. `differ`: the robots' are not the same.
    void showState(const thunderbots::WheelSpeeds& wheels, int limit, bool follow, bool differ);
    void reset();
    void setReleaseToZero(bool on);
    /// What a person asked for last, or what the wheels come to.
    const BodyMotion& motion() const { return motion_; }

    SetPointSlider* axis(int index) const { return axes_[static_cast<std::size_t>(index)]; }

  signals:
    void asked(const kickstand::ui::BodyMotion& motion, bool held);

  private:
    void axisAsked(bool held);
    void showMotion();
    void showWheels(const thunderbots::WheelSpeeds& wheels, bool differ);

    std::array<SetPointSlider*, 3> axes_{};
    QLabel* made_;
    BodyMotion motion_;
    int limit_ = 0;
};

}  // namespace kickstand::ui
