#include "ui/thunderbots/kick_presets.h"

#include <QSettings>
#include <algorithm>

namespace kickstand::ui {

namespace {

constexpr const char* kGroup = "kick/presets";

bool before(const KickPreset& a, const KickPreset& b) {
    return a.name.localeAwareCompare(b.name) < 0;
}

}  // namespace

KickPresets::KickPresets(QSettings& settings) : settings_(settings) {
    const int count = std::min(settings_.beginReadArray(QLatin1String(kGroup)), static_cast<int>(kMost));
    for (int i = 0; i < count; ++i) {
        settings_.setArrayIndex(i);
        KickPreset preset;
        preset.name = tidied(settings_.value("name").toString());
        preset.pulses = {settings_.value("width1_us").toInt(), settings_.value("width2_us").toInt(),
                         settings_.value("offset_us").toInt()};
        if (!preset.name.isEmpty() && find(preset.name) == nullptr) presets_.push_back(preset);
    }
    settings_.endArray();
    std::sort(presets_.begin(), presets_.end(), before);
}

QString KickPresets::tidied(const QString& name) {
    return name.simplified().left(kLongestName);
}

const KickPreset* KickPresets::find(const QString& name) const {
    const auto found = std::find_if(presets_.begin(), presets_.end(),
                                    [&name](const KickPreset& preset) { return preset.name == name; });
    return found == presets_.end() ? nullptr : &*found;
}

bool KickPresets::save(const QString& name, const thunderbots::wire::KickPulses& pulses) {
    const QString kept = tidied(name);
    if (kept.isEmpty()) return false;
    if (find(kept) == nullptr && presets_.size() >= kMost) return false;
    std::erase_if(presets_, [&kept](const KickPreset& preset) { return preset.name == kept; });
    presets_.push_back({kept, pulses});
    write();
    return true;
}

bool KickPresets::rename(const QString& from, const QString& to) {
    const QString kept = tidied(to);
    const KickPreset* preset = find(from);
    if (preset == nullptr || kept.isEmpty() || find(kept) != nullptr) return false;
    const KickPreset renamed{kept, preset->pulses};
    remove(from);
    presets_.push_back(renamed);
    write();
    return true;
}

void KickPresets::remove(const QString& name) {
    if (std::erase_if(presets_, [&name](const KickPreset& preset) { return preset.name == name; }) > 0)
        write();
}

void KickPresets::write() {
    std::sort(presets_.begin(), presets_.end(), before);
    settings_.remove(QLatin1String(kGroup));
    settings_.beginWriteArray(QLatin1String(kGroup), static_cast<int>(presets_.size()));
    for (std::size_t i = 0; i < presets_.size(); ++i) {
        settings_.setArrayIndex(static_cast<int>(i));
        settings_.setValue("name", presets_[i].name);
        settings_.setValue("width1_us", presets_[i].pulses.width1_us);
        settings_.setValue("width2_us", presets_[i].pulses.width2_us);
        settings_.setValue("offset_us", presets_[i].pulses.offset_us);
    }
    settings_.endArray();
}

}  // namespace kickstand::ui
