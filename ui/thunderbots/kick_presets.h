#pragma once

#include <QString>
#include <vector>

#include "core/thunderbots/wire/kick_timing.h"

class QSettings;

namespace kickstand::ui {

/// Pulses under a name.
struct KickPreset {
    QString name;
    thunderbots::wire::KickPulses pulses;

    friend bool operator==(const KickPreset&, const KickPreset&) = default;
};

/// The presets that a person has saved, by name, in the order of their names; written to the settings at
/// once.
class KickPresets {
  public:
    static constexpr std::size_t kMost = 100;
    static constexpr int kLongestName = 40;

    /// `settings` must outlive this.
    explicit KickPresets(QSettings& settings);

    const std::vector<KickPreset>& all() const { return presets_; }
    const KickPreset* find(const QString& name) const;
    /// Keeps pulses under a name, in place of what had it. False for an empty name, or when there are too
    /// many.
    bool save(const QString& name, const thunderbots::wire::KickPulses& pulses);
    /// False where there is none of that name, or the new one is empty or taken.
    bool rename(const QString& from, const QString& to);
    void remove(const QString& name);
    /// A name as it is kept.
    static QString tidied(const QString& name);

  private:
    void write();

    QSettings& settings_;
    std::vector<KickPreset> presets_;
};

}  // namespace kickstand::ui
