#include "ui/thunderbots/drive_pad.h"

#include <QSettings>
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/engine/describe.h"
#include "core/thunderbots/wire/kick_timing.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/body_motion.h"
#include "ui/thunderbots/drive_control.h"
#include "ui/thunderbots/kick_settings.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr const char* kWheelsSetting = "gamepad/wheels";
constexpr const char* kSpeedSetting = "gamepad/speed_percent";

WheelSpeeds wheelsFrom(const PadReading& reading, bool wheels, int limit) {
    if (!wheels) {
        const BodyMotion most = fastestMotion(limit);
        return wheelsOf({reading.of(PadAction::Forward) * most.x_m_per_s,
                         reading.of(PadAction::Left) * most.y_m_per_s,
                         reading.of(PadAction::Turn) * most.turn_rad_per_s},
                        limit)
            .wheels;
    }
    // Forward is negative on the left side (protocol 6.6).
    const int left = static_cast<int>(std::lround(-limit * reading.of(PadAction::LeftWheels)));
    const int right = static_cast<int>(std::lround(limit * reading.of(PadAction::RightWheels)));
    return {left, left, right, right};
}

}  // namespace

DrivePad::DrivePad(Bench& bench, DriveControl& control, KickSettings& kick, MakePadSource makeSource,
                   QObject* parent)
    : QObject(parent),
      bench_(bench),
      control_(control),
      kick_(kick),
      pads_(bench.settings(), std::move(makeSource)) {
    const QSettings& settings = bench_.settings();
    wheels_ = settings.value(kWheelsSetting, false).toBool();
    speed_percent_ = std::clamp(settings.value(kSpeedSetting, speed_percent_).toInt(), 1, 100);
    connect(&control_, &DriveControl::dropped, this, [this] {
        drove_ = false;
        awaitNeutral();
    });
    connect(&pads_, &PadFollower::chose, this, &DrivePad::begin);
    connect(&pads_, &PadFollower::lost, this, &DrivePad::lose);
    connect(&pads_, &PadFollower::looked, this, &DrivePad::act);
    connect(&pads_, &PadFollower::changed, this, &DrivePad::changed);
}

void DrivePad::lose() {
    state_ = {};
    reading_ = {};
    learn(std::nullopt);
    if (on_) {
        control_.brake();
        if (std::exchange(dribbles_, false)) control_.setDribbler(false);
        say(
            tr("The gamepad is gone: the chosen robots were told to brake. Plug it in or wake it up, and let "
               "its sticks go."));
    }
    drove_ = false;
    emit changed();
}

void DrivePad::begin() {
    if (std::exchange(drove_, false)) control_.brake();
    say({});
    reader_ = PadReader();
    state_ = {};
    learn(std::nullopt);
}

void DrivePad::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    awaitNeutral();
    if (!on && std::exchange(drove_, false)) control_.brake();
    say({});
    emit changed();
}

void DrivePad::awaitNeutral() {
    reader_.awaitNeutral();
    reading_ = {};
    reading_.awaitsNeutral = true;
}

void DrivePad::setDrivesWheels(bool wheels) {
    if (wheels == wheels_) return;
    wheels_ = wheels;
    bench_.settings().setValue(kWheelsSetting, wheels);
    if (std::exchange(drove_, false)) control_.brake();
    awaitNeutral();
    learn(std::nullopt);
    emit changed();
}

void DrivePad::setCurve(const StickCurve& curve) {
    pads_.setCurve(curve);
    emit moved();
}

void DrivePad::setSpeed(int percent) {
    speed_percent_ = percent;
    bench_.settings().setValue(kSpeedSetting, percent);
}

void DrivePad::learn(std::optional<PadAction> action) {
    learner_.reset();
    learning_ = isThere() ? action : std::nullopt;
    if (learning_) {
        if (std::exchange(drove_, false)) control_.brake();
        learner_.emplace(state_, isStick(*learning_));
    }
    awaitNeutral();
    emit changed();
}

void DrivePad::setStandardMap() {
    pads_.setMap(PadMap());
    learn(std::nullopt);
}

void DrivePad::learnFrom(const PadState& state) {
    const auto input = learner_->look(state);
    if (!input) return;
    PadMap map = pads_.map();
    map.setInput(*learning_, *input);
    pads_.setMap(map);
    learn(std::nullopt);
}

std::vector<double> DrivePad::positions() const {
    std::vector<double> positions;
    for (const PadAction action : kPadActions) {
        if (isStick(action) && isOfMode(action, wheels_))
            positions.push_back(valueOf(state_, map().input(action)));
    }
    return positions;
}

void DrivePad::act(const PadState& state) {
    const bool awaited = reading_.awaitsNeutral;
    const bool news = state != state_;
    state_ = state;
    reading_ = reader_.read(state, map(), curve(), wheels_);
    // STOP counts whatever else its button might be wanted for.
    if (reading_.wasPressed(PadAction::Stop) && learning_ != PadAction::Stop) {
        if (learning_) {
            learn(std::nullopt);
            say(tr("That is the STOP button. Choose another, or give STOP another button first."));
        }
        bench_.client().stop(StopReason::Person);
        return;
    }
    if (learning_) {
        learnFrom(state);
        if (news) emit moved();
        return;
    }
    if (awaited && !reading_.awaitsNeutral && noticeEndsAtNeutral_) say({});
    if (on_) drive();
    if (awaited != reading_.awaitsNeutral) emit changed();
    if (news) emit moved();
}

void DrivePad::drive() {
    if (reading_.wasPressed(PadAction::Dribbler)) {
        dribbles_ = control_.summary().dribbler != All::Every;
        control_.setDribbler(dribbles_);
    }
    if (reading_.wasPressed(PadAction::Kick)) kick(false);
    if (reading_.wasPressed(PadAction::Chip)) kick(true);
    if (reading_.awaitsNeutral) return;
    const bool off =
        std::any_of(reading_.value.begin(), reading_.value.end(), [](double v) { return v != 0; });
    if (!off && !drove_) return;
    if (off && pads_.isAsleep()) return fallAsleep();
    drove_ = off;
    const int limit = control_.limit() * speed_percent_ / 100;
    const WheelSpeeds wheels = wheelsFrom(reading_, wheels_, limit);
    if (wheels == control_.wheels() && off) return;
    if (control_.setWheels(DriveInput::Gamepad, wheels, true)) return;
    drove_ = false;
    awaitNeutral();
    sayUntilNeutral(tr("Something else is held that drives. Let go of it, and of the sticks."));
}

void DrivePad::fallAsleep() {
    control_.brake();
    drove_ = false;
    awaitNeutral();
    sayUntilNeutral(tr(
        "Nothing has moved on the gamepad for 5 s: the chosen robots were told to brake. Wake it up, and let "
        "its sticks go."));
    emit changed();
}

void DrivePad::kick(bool chip) {
    const RobotMask live = control_.summary().live;
    if (std::popcount(live) != 1) {
        say(tr("A kick is for one robot: choose one that is heard."));
        return;
    }
    const auto encoded =
        wire::encodePulses(pulsesFor(chip ? KickWay::Second : KickWay::First, kick_.pulses()));
    if (!encoded) {
        say(tr("The pulse that is set in the Kick panel does not exist on the wire."));
        return;
    }
    ask(Kick{std::countr_zero(live), encoded->times});
}

void DrivePad::ask(const thunderbots::Command& command) {
    say({});
    bench_.submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        if (!result) say(describe(result.error()).line());
    });
}

void DrivePad::say(const QString& words) {
    noticeEndsAtNeutral_ = false;
    if (words == notice_) return;
    notice_ = words;
    emit changed();
}

void DrivePad::sayUntilNeutral(const QString& words) {
    say(words);
    noticeEndsAtNeutral_ = true;
}

}  // namespace kickstand::ui
