#include "ui/smartdevice/card.h"

#include <array>

#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

const QString kUnknown = QStringLiteral("\u2014");

struct CardKind {
    std::string_view device;
    std::string_view needs;  ///< A parameter without which it is another board of that name.
    CardContent (*make)(const CardValues&);
};
constexpr std::array kCards{
    CardKind{"PolarBear", "duty_cycle", motorCard},     CardKind{"YogiBear", "duty_cycle", motorCard},
    CardKind{"BatteryBuzzer", "v_batt", batteryCard},   CardKind{"LimitSwitch", "switch0", switchesCard},
    CardKind{"LineFollower", "left", lineFollowerCard}, CardKind{"Potentiometer", "pot0", dialsCard},
    CardKind{"Encoder", "rotation", encoderCard},       CardKind{"ServoControl", "servo0", servosCard},
    CardKind{"TeamFlag", "mode", teamFlagCard},         CardKind{"RFID", "detect_tag", tagCard}};

}  // namespace

const ParameterState* CardValues::find(std::string_view name) const {
    const int at = device_.spec->find(name);
    const bool there = at >= 0 && static_cast<std::size_t>(at) < device_.parameters.size();
    return there ? &device_.parameters[static_cast<std::size_t>(at)] : nullptr;
}

std::optional<double> CardValues::number(std::string_view name) const {
    const ParameterState* state = find(name);
    return state == nullptr || !state->value ? std::nullopt : wire::toNumber(*state->value);
}

std::optional<double> CardValues::written(std::string_view name) const {
    const ParameterState* state = find(name);
    return state == nullptr || !state->written ? std::nullopt : wire::toNumber(*state->written);
}

QString CardValues::text(std::string_view name, int decimals) const {
    const auto value = number(name);
    if (!value) return kUnknown;
    const ParameterSpec& spec = device_.spec->parameters[static_cast<std::size_t>(device_.spec->find(name))];
    return marked(withUnit(numberText(*value, decimals), spec), name);
}

QString CardValues::marked(const QString& text, std::string_view name) const {
    const ParameterState* state = find(name);
    if (state == nullptr || !state->value) return kUnknown;
    return isOld(*state, device_, now_) ? text + u'?' : text;
}

CardContent cardOf(const DeviceState& device, TimePoint now) {
    const CardValues values(device, now);
    for (const CardKind& kind : kCards) {
        if (kind.device == device.spec->name && device.spec->find(kind.needs) >= 0) return kind.make(values);
    }
    return plainCard(values);
}

QString cardWords(const CardContent& content) {
    QStringList words;
    for (const auto& column : content.columns) {
        for (const CardPart& part : column) {
            QStringList own{part.caption, part.text};
            for (const CardPart::Lamp& lamp : part.lamps) {
                if (lamp.lit) own << lamp.label;
            }
            own.removeAll(QString());
            if (!own.isEmpty()) words << own.join(u' ');
        }
    }
    return words.join(QStringLiteral(", "));
}

}  // namespace kickstand::ui
