#include "ui/coach/helm_gamepad.h"

#include <utility>

#include "ui/coach/helm_pad.h"
#include "ui/shell/bench.h"

namespace kickstand::ui {

using coach::wire::nearestLevel;
using coach::wire::Velocity;

HelmGamepad::HelmGamepad(Bench& bench, HelmPad& helm, MakePadSource makeSource, QObject* parent)
    : QObject(parent), bench_(bench), helm_(helm), pads_(bench.settings(), std::move(makeSource)) {
    connect(&pads_, &PadFollower::chose, this, [this] {
        gone_ = false;
        drop();
    });
    connect(&pads_, &PadFollower::lost, this, [this] {
        gone_ = true;
        drop();
    });
    connect(&pads_, &PadFollower::looked, this, &HelmGamepad::look);
    connect(&pads_, &PadFollower::changed, this, &HelmGamepad::changed);
}

void HelmGamepad::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    drop();
    if (on) pads_.open();
}

void HelmGamepad::drop() {
    if (std::exchange(steers_, false)) helm_.letGo();
    awaitNeutral();
}

void HelmGamepad::awaitNeutral() {
    reader_.awaitNeutral();
    awaitsNeutral_ = true;
    steers_ = false;
    emit changed();
}

void HelmGamepad::look(const PadState& state) {
    const PadReading reading = reader_.read(state, pads_.map(), pads_.curve(), false);
    if (reading.wasPressed(PadAction::Stop)) {
        bench_.client().stop(StopReason::Person);
        return;
    }
    if (std::exchange(awaitsNeutral_, reading.awaitsNeutral) != reading.awaitsNeutral) emit changed();
    if (!on_ || reading.awaitsNeutral) return;
    const Velocity asked{nearestLevel(100 * reading.of(PadAction::Forward)),
                         nearestLevel(100 * reading.of(PadAction::Turn))};
    if (!asked.isZero() && pads_.isAsleep()) return drop();
    // What rests leaves the helm to pointer and keys.
    if (asked.isZero() && !steers_) return;
    steers_ = !asked.isZero();
    if (!helm_.hold(asked)) awaitNeutral();
}

QString HelmGamepad::stateText() const {
    if (!on_) return {};
    if (gone_)
        return tr(
            "The gamepad is gone: zero was asked for. Plug it in or wake it up, and let its sticks go.");
    if (!pads_.isThere()) return tr("Plug a gamepad in. It is found at once.");
    if (awaitsNeutral_) return tr("Let the sticks go once: then they count.");
    return tr("The gamepad steers. Letting the sticks go stops.");
}

}  // namespace kickstand::ui
