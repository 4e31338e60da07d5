#include "ui/gamepad/pad_follower.h"

#include <QSettings>
#include <algorithm>
#include <chrono>
#include <utility>

namespace kickstand::ui {
namespace {

using namespace std::chrono_literals;

/// As often as the fastest link takes commands.
constexpr auto kPollInterval = 8ms;
constexpr std::chrono::milliseconds kAsleepAfter = 5s;
constexpr const char* kModelSetting = "gamepad/model";
constexpr const char* kDeadZoneSetting = "gamepad/deadZone";
constexpr const char* kBendSetting = "gamepad/bend";

QString mapSetting(const PadInfo& pad) {
    return QStringLiteral("gamepad/map/%1").arg(QString::fromStdString(pad.model));
}

}  // namespace

PadFollower::PadFollower(QSettings& settings, MakePadSource makeSource, QObject* parent)
    : QObject(parent), settings_(settings), makeSource_(std::move(makeSource)) {
    curve_.deadZone = std::clamp(settings_.value(kDeadZoneSetting, curve_.deadZone).toDouble(), 0.0, 0.9);
    curve_.bend = std::clamp(settings_.value(kBendSetting, curve_.bend).toDouble(), 0.0, 1.0);
    chosen_.model = settings_.value(kModelSetting).toString().toStdString();
    connect(&timer_, &QTimer::timeout, this, &PadFollower::poll);
    timer_.setTimerType(Qt::PreciseTimer);
}

void PadFollower::open() {
    if (source_ != nullptr) return;
    source_ = makeSource_();
    timer_.start(kPollInterval);
    poll();
}

void PadFollower::poll() {
    source_->update();
    followPads();
    const auto state = there_ ? source_->state(chosen_.id) : std::nullopt;
    if (there_ && !state) lose();
    if (!state) return;
    if (*state != state_) moved_.start();
    state_ = *state;
    emit looked(*state);
}

void PadFollower::followPads() {
    std::vector<PadInfo> pads = source_->pads();
    if (pads == pads_) return;
    pads_ = std::move(pads);
    const auto find = [this](auto same) { return std::find_if(pads_.begin(), pads_.end(), same); };
    if (there_ && find([this](const PadInfo& pad) { return pad.id == chosen_.id; }) == pads_.end()) lose();
    if (!there_) {
        // The one that was used last comes back as it was; with none chosen yet, the first one will do.
        const auto back =
            find([this](const PadInfo& pad) { return chosen_.model.empty() || pad.model == chosen_.model; });
        if (back != pads_.end()) choose(*back);
    }
    emit changed();
}

bool PadFollower::isAsleep() const {
    return moved_.isValid() && moved_.hasExpired(kAsleepAfter.count());
}

void PadFollower::lose() {
    there_ = false;
    emit lost();
}

void PadFollower::choose(const PadInfo& pad) {
    if (there_ && pad.id == chosen_.id) return;
    chosen_ = pad;
    there_ = true;
    settings_.setValue(kModelSetting, QString::fromStdString(pad.model));
    map_ = PadMap();
    map_.setText(settings_.value(mapSetting(chosen_)).toString());
    if (map_.input(PadAction::Stop).kind == PadInput::Kind::None)
        map_.setInput(PadAction::Stop, PadMap().input(PadAction::Stop));
    emit chose();
}

void PadFollower::setMap(const PadMap& map) {
    map_ = map;
    settings_.setValue(mapSetting(chosen_), map_.toText());
}

void PadFollower::setCurve(const StickCurve& curve) {
    curve_ = curve;
    settings_.setValue(kDeadZoneSetting, curve.deadZone);
    settings_.setValue(kBendSetting, curve.bend);
}

}  // namespace kickstand::ui
