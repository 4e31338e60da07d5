#pragma once

#include <QObject>
#include <array>

#include "core/thunderbots/wire/kick_timing.h"

class QSettings;

namespace kickstand::ui {

/// The three ways of kicking by hand.
enum class KickWay { First, Second, Both };
inline constexpr std::array kKickWays{KickWay::First, KickWay::Second, KickWay::Both};

/// The pulses that a person has set, for every panel that kicks, and what the buttons are called. Remembered
/// between runs. GUI thread.
class KickSettings final : public QObject {
    Q_OBJECT
  public:
    static constexpr int kLongestLabel = 20;

    explicit KickSettings(QObject* parent = nullptr);

    /// Takes what was remembered, and remembers there from now on. It must outlive this.
    void attach(QSettings& settings);

    /// On the grid of 32 µs; not always possible on the wire.
    const thunderbots::wire::KickPulses& pulses() const { return pulses_; }
    /// Every number goes to the nearest step within ±4064 µs.
    void setPulses(const thunderbots::wire::KickPulses& pulses);

    QString label(KickWay way) const;
    /// Empty: back to the label that it has by itself.
    void setLabel(KickWay way, const QString& label);

  signals:
    void changed();
    void labelsChanged();

  private:
    void remember();

    QSettings* settings_ = nullptr;
    thunderbots::wire::KickPulses pulses_{2400, 0, 0};
    std::array<QString, kKickWays.size()> labels_;
};

/// What one way of kicking makes of the pulses: the first solenoid alone, the second alone, or both.
thunderbots::wire::KickPulses pulsesFor(KickWay way, const thunderbots::wire::KickPulses& pulses);

}  // namespace kickstand::ui
