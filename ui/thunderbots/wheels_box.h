#pragma once

#include <QWidget>
#include <array>

#include "ui/thunderbots/body_motion.h"
#include "ui/thunderbots/wheel_unit.h"

class QCheckBox;
class QPushButton;
class QStackedWidget;

namespace kickstand::ui {

class BodyBox;
class DriveControl;
class LimitRow;
class Segmented;
class SetPointSlider;

/// Four wheels or the body's motion, run or brake, the dribbler, and the limit. It shows and asks; the panel
/// decides.
class WheelsBox final : public QWidget {
    Q_OBJECT
  public:
    explicit WheelsBox(QWidget* parent = nullptr);

    void showState(const DriveControl& control);
    void setUsable(bool usable);
    /// What is shown beside the set points from the next showState() on.
    void setUnit(WheelUnit unit) { unit_ = unit; }
    /// Everything to zero, whoever holds it.
    void reset();
    void setReleaseToZero(bool on);
    /// Whether the body's motion is set, and not each wheel.
    bool isBody() const;
    void setBody(bool on);

    /// Stands wherever there is room for it.
    QCheckBox* releaseBox() const { return release_; }
    SetPointSlider* wheel(int index) const { return wheels_[static_cast<std::size_t>(index)]; }

  signals:
    void wheelAsked(int wheel, int value, bool held);
    void bodyAsked(const kickstand::ui::BodyMotion& motion, bool held);
    void bodyChosen(bool on);
    void runAsked();
    void brakeAsked();
    void zeroAsked();
    void dribblerAsked(bool on);
    void limitAsked(int limit);
    void releaseToZeroChanged(bool on);

  private:
    QWidget* makeTop();
    QWidget* makeWheels();
    QWidget* makeBottom();

    Segmented* mode_;
    Segmented* run_;
    QCheckBox* release_;
    std::array<SetPointSlider*, thunderbots::kWheels> wheels_{};
    BodyBox* body_;
    QStackedWidget* pages_;
    QPushButton* dribbler_;
    QPushButton* zero_;
    LimitRow* limit_;
    WheelUnit unit_ = WheelUnit::Rpm;
};

}  // namespace kickstand::ui
