#pragma once

#include <QString>
#include <optional>
#include <string_view>
#include <vector>

#include "core/smartdevice/snapshot.h"
#include "ui/widgets/state_label.h"

namespace kickstand::ui {

/// One thing on a card.
struct CardPart {
    enum class Kind {
        Number,  ///< A large number over its caption.
        Level,   ///< A bar from the left, `value` 0 to 1.
        Centre,  ///< A bar from the middle, `value` -1 to 1.
        Arc,     ///< A dial whose track is a sector, `value` 0 to 1.
        Turn,    ///< A dial that goes round without end, `value` in turns.
        Lamps,
        Words,  ///< A shape and words.
    };
    enum class Light { Plain, Blue, Yellow };
    struct Lamp {
        QString label;
        bool lit = false;
        Light light = Light::Plain;
        friend bool operator==(const Lamp&, const Lamp&) = default;
    };

    Kind kind = Kind::Words;
    QString caption;
    QString text;
    std::optional<double> value{};  ///< Nothing is drawn of what is not known.
    double low = -2;                ///< Marks on the track; outside of it for none.
    double high = -2;
    Tone tone = Tone::Idle;
    std::vector<Lamp> lamps{};

    friend bool operator==(const CardPart&, const CardPart&) = default;
};

/// What a board is about, at a glance: parts in columns.
struct CardContent {
    std::vector<std::vector<CardPart>> columns;
    int width = 1;  ///< In cards.

    friend bool operator==(const CardContent&, const CardContent&) = default;
};

/// A board's values by their parameters' names.
class CardValues {
  public:
    CardValues(const smartdevice::DeviceState& device, TimePoint now) : device_(device), now_(now) {}

    const smartdevice::DeviceState& device() const { return device_; }
    std::optional<double> number(std::string_view name) const;
    bool isOn(std::string_view name) const { return number(name).value_or(0) != 0; }
    /// What was written last.
    std::optional<double> written(std::string_view name) const;
    /// The value with so many places and its unit; a dash where it is not known, a question mark behind what
    /// is old.
    QString text(std::string_view name, int decimals) const;
    /// A number that was made of this parameter's value, in the same way.
    QString marked(const QString& text, std::string_view name) const;

  private:
    const smartdevice::ParameterState* find(std::string_view name) const;

    const smartdevice::DeviceState& device_;
    TimePoint now_;
};

/// The card for a kind of board; for one that has none of its own its first parameters.
CardContent cardOf(const smartdevice::DeviceState& device, TimePoint now);
/// All of a card's words, as they are read.
QString cardWords(const CardContent& content);

// Each in its file.
CardContent motorCard(const CardValues& values);
CardContent batteryCard(const CardValues& values);
CardContent switchesCard(const CardValues& values);
CardContent lineFollowerCard(const CardValues& values);
CardContent dialsCard(const CardValues& values);
CardContent encoderCard(const CardValues& values);
CardContent servosCard(const CardValues& values);
CardContent teamFlagCard(const CardValues& values);
CardContent tagCard(const CardValues& values);
CardContent plainCard(const CardValues& values);

}  // namespace kickstand::ui
