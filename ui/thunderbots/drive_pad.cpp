#include "ui/thunderbots/drive_pad.h"

#include <QSettings>
#include <algorithm>
#include <bit>
#include <chrono>
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

using namespace std::chrono_literals;

/// As often as the link takes blocks for sixteen robots.
constexpr auto kPollInterval = 8ms;
constexpr const char* kModelSetting = "gamepad/model";
constexpr const char* kWheelsSetting = "gamepad/wheels";
constexpr const char* kDeadZoneSetting = "gamepad/deadZone";
constexpr const char* kBendSetting = "gamepad/bend";
constexpr const char* kSpeedSetting = "gamepad/speed_percent";

QString mapSetting(const PadInfo& pad) {
    return QStringLiteral("gamepad/map/%1").arg(QString::fromStdString(pad.model));
}

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

DrivePad::DrivePad(Bench& bench, DriveControl& control, KickSettings& kick, MakeSource makeSource,
                   QObject* parent)
    : QObject(parent), bench_(bench), control_(control), kick_(kick), makeSource_(std::move(makeSource)) {
    const QSettings& settings = bench_.settings();
    wheels_ = settings.value(kWheelsSetting, false).toBool();
    curve_.deadZone = std::clamp(settings.value(kDeadZoneSetting, curve_.deadZone).toDouble(), 0.0, 0.9);
    curve_.bend = std::clamp(settings.value(kBendSetting, curve_.bend).toDouble(), 0.0, 1.0);
    speed_percent_ = std::clamp(settings.value(kSpeedSetting, speed_percent_).toInt(), 1, 100);
    chosen_.model = settings.value(kModelSetting).toString().toStdString();
    connect(&control_, &DriveControl::dropped, this, [this] {
        drove_ = false;
        awaitNeutral();
    });
    connect(&timer_, &QTimer::timeout, this, &DrivePad::poll);
    timer_.setTimerType(Qt::PreciseTimer);
}

void DrivePad::open() {
    if (source_ != nullptr) return;
    source_ = makeSource_();
    timer_.start(kPollInterval);
    poll();
}

void DrivePad::poll() {
    source_->update();
    followPads();
    const auto state = there_ ? source_->state(chosen_.id) : std::nullopt;
    if (there_ && !state) lose();
    if (state) act(*state);
}

void DrivePad::followPads() {
    std::vector<PadInfo> pads = source_->pads();
    if (pads == pads_) return;
    pads_ = std::move(pads);
    const auto has = [this](auto same) { return std::find_if(pads_.begin(), pads_.end(), same); };
    if (there_ && has([this](const PadInfo& pad) { return pad.id == chosen_.id; }) == pads_.end()) lose();
    if (!there_) {
        // The one that was used last comes back as it was; with none chosen yet, the first one will do.
        const auto back =
            has([this](const PadInfo& pad) { return chosen_.model.empty() || pad.model == chosen_.model; });
        if (back != pads_.end()) choose(*back);
    }
    emit changed();
}

void DrivePad::lose() {
    there_ = false;
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

void DrivePad::choose(const PadInfo& pad) {
    if (there_ && pad.id == chosen_.id) return;
    if (drove_) control_.brake();
    drove_ = false;
    chosen_ = pad;
    there_ = true;
    reader_ = PadReader();
    state_ = {};
    learn(std::nullopt);
    bench_.settings().setValue(kModelSetting, QString::fromStdString(pad.model));
    readMap();
    emit changed();
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
    curve_ = curve;
    bench_.settings().setValue(kDeadZoneSetting, curve.deadZone);
    bench_.settings().setValue(kBendSetting, curve.bend);
    emit moved();
}

void DrivePad::setSpeed(int percent) {
    speed_percent_ = percent;
    bench_.settings().setValue(kSpeedSetting, percent);
}

void DrivePad::learn(std::optional<PadAction> action) {
    learner_.reset();
    learning_ = there_ ? action : std::nullopt;
    if (learning_) {
        if (std::exchange(drove_, false)) control_.brake();
        learner_.emplace(state_, isStick(*learning_));
    }
    awaitNeutral();
    emit changed();
}

void DrivePad::setStandardMap() {
    map_ = PadMap();
    writeMap();
    learn(std::nullopt);
}

void DrivePad::readMap() {
    map_ = PadMap();
    map_.setText(bench_.settings().value(mapSetting(chosen_)).toString());
}

void DrivePad::writeMap() {
    bench_.settings().setValue(mapSetting(chosen_), map_.toText());
}

void DrivePad::learnFrom(const PadState& state) {
    const auto input = learner_->look(state);
    if (!input) return;
    map_.setInput(*learning_, *input);
    writeMap();
    learn(std::nullopt);
}

std::vector<double> DrivePad::positions() const {
    std::vector<double> positions;
    for (const PadAction action : kPadActions) {
        if (isStick(action) && isOfMode(action, wheels_))
            positions.push_back(valueOf(state_, map_.input(action)));
    }
    return positions;
}

void DrivePad::act(const PadState& state) {
    const bool awaited = reading_.awaitsNeutral;
    const bool news = state != state_;
    state_ = state;
    if (learning_) {
        learnFrom(state);
        if (news) emit moved();
        return;
    }
    reading_ = reader_.read(state, map_, curve_, wheels_);
    if (reading_.wasPressed(PadAction::Stop)) {
        bench_.client().stop(StopReason::Person);
        return;
    }
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
    drove_ = off;
    const int limit = control_.limit() * speed_percent_ / 100;
    const WheelSpeeds wheels = wheelsFrom(reading_, wheels_, limit);
    if (wheels == control_.wheels() && off) return;
    if (control_.setWheels(DriveInput::Gamepad, wheels, true)) return;
    drove_ = false;
    awaitNeutral();
    say(tr("Something else is held that drives. Let go of it, and of the sticks."));
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
    if (words == notice_) return;
    notice_ = words;
    emit changed();
}

}  // namespace kickstand::ui
