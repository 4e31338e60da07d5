#include "ui/thunderbots/kick_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/engine/describe.h"
#include "core/thunderbots/wire/readings.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(KickWords)
};

QString dropText(const KickRecord& record) {
    const int drop_V = static_cast<int>(std::lround(*record.before_V) - std::lround(*record.after_V));
    return Words::tr("%1 \u2192 %2 (%3 V)")
        .arg(static_cast<int>(std::lround(*record.before_V)))
        .arg(capacitorText(*record.after_V), signedNumber(-drop_V));
}

QString stageText(SweepStage stage) {
    switch (stage) {
        case SweepStage::Charging:
            return Words::tr("charging");
        case SweepStage::Pausing:
            return Words::tr("pause");
        case SweepStage::Measuring:
            return Words::tr("measuring");
        case SweepStage::Ended:
            return Words::tr("ended");
    }
    return {};
}

/// "not charged" reads as safe to touch: it is not said of what is live.
QString chargeWord(const Readings& readings, bool charger) {
    if (readings.charged) return Words::tr("charged");
    if (readings.capacitor_V < wire::kCapacitorLive_V) return Words::tr("not charged");
    return charger ? Words::tr("recharging") : Words::tr("charger off, still live");
}

}  // namespace

QString secondsText(Duration span) {
    return Words::tr("%1 s").arg(seconds(span), 0, 'f', 1);
}

QString pulsesText(const wire::KickPulses& pulses) {
    QString text = Words::tr("%1 / %2 \u00b5s").arg(pulses.width1_us).arg(pulses.width2_us);
    if (pulses.offset_us > 0) text += Words::tr(", solenoid 2 later by %1 \u00b5s").arg(pulses.offset_us);
    if (pulses.offset_us < 0) text += Words::tr(", solenoid 1 later by %1 \u00b5s").arg(-pulses.offset_us);
    return text;
}

QString wireText(const wire::KickTimes& times) {
    return Words::tr("t1 %1 \u00b7 t2 %2 \u00b7 \u0394t %3 \u00b7 flags %4 %5")
        .arg(times.t1)
        .arg(times.t2)
        .arg(times.dt)
        .arg(times.flag1 ? 1 : 0)
        .arg(times.flag2 ? 1 : 0);
}

QString measureWord(KickMeasure measure) {
    switch (measure) {
        case KickMeasure::Waiting:
        case KickMeasure::Recharging:
            return Words::tr("measuring");
        case KickMeasure::Recharged:
            return Words::tr("measured");
        case KickMeasure::NoDrop:
            return Words::tr("no drop");
        case KickMeasure::NotRecharged:
            return Words::tr("not full again");
        case KickMeasure::Overtaken:
            return Words::tr("kicked again");
        case KickMeasure::Lost:
            return Words::tr("not measured");
    }
    return {};
}

QString measureText(const KickRecord& record) {
    switch (record.measure) {
        case KickMeasure::Waiting:
            return Words::tr("measuring\u2026");
        case KickMeasure::Recharging:
            return Words::tr("%1, charging again\u2026").arg(dropText(record));
        case KickMeasure::Recharged:
            return Words::tr("%1, charged again in %2").arg(dropText(record), secondsText(*record.recharge));
        case KickMeasure::NoDrop:
            return Words::tr("the capacitor stayed at %1").arg(capacitorText(*record.after_V));
        case KickMeasure::NotRecharged:
            return Words::tr("%1, not full again").arg(dropText(record));
        case KickMeasure::Overtaken:
        case KickMeasure::Lost:
            break;
    }
    const QString why = record.measure == KickMeasure::Lost ? Words::tr("the readings are missing")
                                                            : Words::tr("another kick came too soon");
    if (record.drop_V()) return Words::tr("%1, recharge not measured: %2").arg(dropText(record), why);
    return Words::tr("not measured: %1").arg(why);
}

QString causeText(KickCause cause) {
    switch (cause) {
        case KickCause::Asked:
            return Words::tr("by hand");
        case KickCause::Sweep:
            return Words::tr("sweep");
        case KickCause::Autokick:
            return Words::tr("autokick");
    }
    return {};
}

QString sweepText(const SweepProgress& sweep) {
    if (!sweep.running()) {
        if (!sweep.endedBy) return Words::tr("Done: %1 kicks given to the dongle.").arg(sweep.given);
        Error error;
        error.code = *sweep.endedBy;
        error.robot = sweep.plan.robot;
        if (error.code == Errc::Cancelled)
            return Words::tr("Stopped after %1 of %2 kicks.").arg(sweep.given).arg(sweep.total);
        return Words::tr("Ended after %1 of %2 kicks. %3")
            .arg(sweep.given)
            .arg(sweep.total)
            .arg(describe(error).what);
    }
    const int next =
        std::min(sweep.stage == SweepStage::Measuring ? sweep.given : sweep.given + 1, sweep.total);
    const int step = std::max(0, next - 1) / sweep.plan.kicksPerStep;
    const auto encoded = wire::encodePulses(pulsesAt(sweep.plan, step));
    const wire::KickPulses pulses = encoded ? encoded->sent : wire::KickPulses{};
    return Words::tr("kick %1 of %2 \u00b7 %3 \u00b7 %4")
        .arg(next)
        .arg(sweep.total)
        .arg(pulsesText(pulses), stageText(sweep.stage));
}

QString chargeText(const ChargeRecord& charge, const Readings& readings, bool charger, TimePoint now) {
    if (charge.since) return Words::tr("charging for %1").arg(secondsText(now - *charge.since));
    const QString state = chargeWord(readings, charger);
    if (!charge.toCharged) return state;
    return Words::tr("%1 \u00b7 took %2 from switching on").arg(state, secondsText(*charge.toCharged));
}

}  // namespace kickstand::ui
