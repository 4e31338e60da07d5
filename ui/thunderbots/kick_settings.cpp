#include "ui/thunderbots/kick_settings.h"

#include <QSettings>
#include <algorithm>

#include "ui/thunderbots/kick_diagram.h"

namespace kickstand::ui {

using namespace thunderbots::wire;

namespace {

constexpr const char* kWidth1Setting = "kick/width1_us";
constexpr const char* kWidth2Setting = "kick/width2_us";
constexpr const char* kOffsetSetting = "kick/offset_us";

QString labelSetting(KickWay way) {
    return QStringLiteral("kick/label%1").arg(static_cast<int>(way) + 1);
}

int width(int value_us) {
    return snappedTime(value_us);
}

}  // namespace

KickSettings::KickSettings(QObject* parent) : QObject(parent) {}

void KickSettings::attach(QSettings& settings) {
    settings_ = nullptr;
    for (const KickWay way : kKickWays)
        setLabel(way, settings.value(labelSetting(way)).toString());
    setPulses({settings.value(kWidth1Setting, pulses_.width1_us).toInt(),
               settings.value(kWidth2Setting, pulses_.width2_us).toInt(),
               settings.value(kOffsetSetting, pulses_.offset_us).toInt()});
    settings_ = &settings;
}

void KickSettings::setPulses(const KickPulses& pulses) {
    const KickPulses wanted{width(pulses.width1_us), width(pulses.width2_us),
                            onGrid(std::clamp(pulses.offset_us, -kKickMax_us, kKickMax_us))};
    if (wanted == pulses_) return;
    pulses_ = wanted;
    remember();
    emit changed();
}

void KickSettings::remember() {
    if (settings_ == nullptr) return;
    settings_->setValue(kWidth1Setting, pulses_.width1_us);
    settings_->setValue(kWidth2Setting, pulses_.width2_us);
    settings_->setValue(kOffsetSetting, pulses_.offset_us);
}

QString KickSettings::label(KickWay way) const {
    const QString& own = labels_[static_cast<std::size_t>(way)];
    if (!own.isEmpty()) return own;
    switch (way) {
        case KickWay::First:
            return tr("Kick");
        case KickWay::Second:
            return tr("Chip");
        case KickWay::Both:
            return tr("Both");
    }
    return {};
}

void KickSettings::setLabel(KickWay way, const QString& label) {
    QString& own = labels_[static_cast<std::size_t>(way)];
    const QString wanted = label.simplified().left(kLongestLabel);
    if (wanted == own) return;
    own = wanted;
    if (settings_ != nullptr) settings_->setValue(labelSetting(way), own);
    emit labelsChanged();
}

KickPulses pulsesFor(KickWay way, const KickPulses& pulses) {
    switch (way) {
        case KickWay::First:
            return {pulses.width1_us, 0, 0};
        case KickWay::Second:
            return {0, pulses.width2_us, 0};
        case KickWay::Both:
            return pulses;
    }
    return {};
}

}  // namespace kickstand::ui
