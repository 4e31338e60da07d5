#pragma once

#include <QObject>

#include "core/thunderbots/commands.h"
#include "ui/gamepad/pad_follower.h"
#include "ui/gamepad/pad_learner.h"
#include "ui/gamepad/pad_reader.h"

namespace kickstand::ui {

class Bench;
class DriveControl;
class KickSettings;

/// Drives with a gamepad: what it asks for goes the way that sliders and keys go. GUI thread.
class DrivePad final : public QObject {
    Q_OBJECT
  public:
    DrivePad(Bench& bench, DriveControl& control, KickSettings& kick, MakePadSource makeSource,
             QObject* parent = nullptr);

    /// Begins to look for gamepads. From then on STOP of the chosen one counts, whether it drives or not.
    void open() { pads_.open(); }
    const std::vector<PadInfo>& pads() const { return pads_.pads(); }
    /// The one that is chosen, whether it is plugged in or not; its model is empty while none has been.
    const PadInfo& chosen() const { return pads_.chosen(); }
    bool isThere() const { return pads_.isThere(); }
    void choose(const PadInfo& pad) { pads_.choose(pad); }

    bool isOn() const { return on_; }
    void setOn(bool on);
    bool drivesWheels() const { return wheels_; }
    void setDrivesWheels(bool wheels);
    const StickCurve& curve() const { return pads_.curve(); }
    void setCurve(const StickCurve& curve);
    /// How fast a stick at its end drives, in percent of the limit.
    int speed_percent() const { return speed_percent_; }
    void setSpeed(int percent);

    const PadMap& map() const { return pads_.map(); }
    /// The next stick or button that is moved gets this action; none: stop waiting for it.
    void learn(std::optional<PadAction> action);
    std::optional<PadAction> learning() const { return learning_; }
    void setStandardMap();

    /// Where the sticks of this way of driving stand, before the curve.
    std::vector<double> positions() const;
    bool awaitsNeutral() const { return reading_.awaitsNeutral; }
    /// What happened last, as a sentence.
    const QString& notice() const { return notice_; }

  signals:
    void changed();
    /// The sticks stand elsewhere.
    void moved();

  private:
    void begin();
    void lose();
    void act(const PadState& state);
    void learnFrom(const PadState& state);
    void awaitNeutral();
    void drive();
    void fallAsleep();
    void kick(bool chip);
    void ask(const thunderbots::Command& command);
    void say(const QString& words);
    /// The same, until the sticks have been let go.
    void sayUntilNeutral(const QString& words);

    Bench& bench_;
    DriveControl& control_;
    KickSettings& kick_;
    PadFollower pads_;
    bool on_ = false;
    bool wheels_ = false;
    int speed_percent_ = 100;
    PadReader reader_;
    PadReading reading_;
    PadState state_;
    bool drove_ = false;     ///< The sticks have been off the middle since they last were there.
    bool dribbles_ = false;  ///< It has switched the dribbler on.
    std::optional<PadAction> learning_;
    std::optional<PadLearner> learner_;
    QString notice_;
    bool noticeEndsAtNeutral_ = false;
};

}  // namespace kickstand::ui
