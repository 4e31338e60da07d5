#pragma once

#include <functional>

#include "core/base/session_host.h"
#include "core/thunderbots/events.h"
#include "core/thunderbots/kick_record.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::thunderbots {

/// Measures what each kick does to its robot's capacitor, from the readings alone, and keeps the newest. It
/// stands between the model and the plots: readings pass through it. Engine thread.
class KickLog final : public SampleSink {
  public:
    /// Records that are kept; older ones give way.
    static constexpr std::size_t kMost = 256;
    /// A fall of less than this is noise.
    static constexpr double kLeastDrop_V = 0.5;
    /// No fall by then: the kick did not reach the capacitor.
    static constexpr Duration kDropLimit = std::chrono::milliseconds(1500);
    /// After the first low reading a lower one may still follow for so long.
    static constexpr Duration kSettle = std::chrono::milliseconds(300);
    /// Not charged again by then: nobody waits longer.
    static constexpr Duration kRechargeLimit = std::chrono::seconds(30);
    /// What counts as charged again, as a part of the voltage before.
    static constexpr double kRecharged = 0.98;

    /// `onward` takes every reading after this; `event` is told of what was measured. Both outlive this.
    KickLog(SampleSink& onward, std::function<void(const Event&)> event);

    void sample(SignalId signal, TimePoint time, float value) override;
    void gap(SignalId signal, TimePoint time) override;
    /// What the model tells of a robot that is in this state now.
    void heard(const Event& event, const RobotState& state);
    /// What the next kick that the dongle takes is due to; none for a pulse that is no kick.
    void expect(std::optional<KickCause> cause) { expected_ = cause; }
    /// Whether it is a kick, and not a pulse of a discharge.
    bool expectsKick() const { return expected_.has_value(); }
    /// The times that this robot kicks with by itself from now on.
    void autokickSet(int robot, const wire::KickTimes& times) { at(robot).autokick = times; }
    /// Ends what has taken too long.
    void tick(TimePoint now);

    /// Whether it is not known yet what this robot's kicks have done.
    bool measuring(int robot) const {
        const Robot& known = robots_[static_cast<std::size_t>(robot)];
        return known.open.has_value() || known.unclearUntil.has_value();
    }
    /// Immutable once given out; never null.
    std::shared_ptr<const KickRecords> records() const { return shown_; }
    const std::array<ChargeRecord, kRobots>& charges() const { return charges_; }
    /// Rises whenever records() or charges() would give something else.
    std::uint64_t version() const { return version_; }

  private:
    /// The highest reading of the last second or two, and the lowest since: an autokick is told of only after
    /// it has happened, and often after its effect has been read.
    struct Recent {
        TimePoint began{};
        double newer_V = 0;
        double older_V = 0;
        double lowest_V = 0;
        double last_V = 0;
        void restart(TimePoint time, double volts);
        void add(TimePoint time, double volts);
        void roll(TimePoint time);
        double peak_V() const { return newer_V > older_V ? newer_V : older_V; }
    };
    /// A measurement under way: the record's place and what is not part of it.
    struct Open {
        std::uint64_t number = 0;
        TimePoint fellAt{};
        std::optional<TimePoint> crossedAt;
    };
    struct Robot {
        bool known = false;  ///< Whether the voltage is known now.
        Recent recent;
        std::optional<Open> open;
        /// Until then a fall may be due to kicks that are not measured.
        std::optional<TimePoint> unclearUntil;
        std::optional<wire::KickTimes> autokick;
    };

    void begin(int robot, KickCause cause, const std::optional<wire::KickTimes>& times, TimePoint time);
    bool isTooSoon(int robot, bool autokick, TimePoint time);
    void measureFrom(int robot, KickRecord& record, TimePoint time);
    void reading(int robot, double volts, TimePoint time);
    void unknown(int robot, TimePoint time);
    void fall(KickRecord& record, Open& open, double volts, TimePoint time);
    void advance(int robot, TimePoint time);
    void finish(int robot, KickMeasure how, TimePoint time);
    KickRecord& recordOf(const Open& open);
    void publish();
    Robot& at(int robot) { return robots_[static_cast<std::size_t>(robot)]; }
    ChargeRecord& chargeOf(int robot) { return charges_[static_cast<std::size_t>(robot)]; }

    SampleSink& onward_;
    std::function<void(const Event&)> event_;
    std::array<Robot, kRobots> robots_;
    std::array<ChargeRecord, kRobots> charges_;
    std::optional<KickCause> expected_ = KickCause::Asked;
    KickRecords records_;
    std::uint64_t given_ = 0;
    std::shared_ptr<const KickRecords> shown_ = std::make_shared<const KickRecords>();
    std::uint64_t version_ = 0;
};

}  // namespace kickstand::thunderbots
