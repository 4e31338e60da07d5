#include "ui/gamepad/pad_map.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace kickstand::ui {

namespace {

struct PadText {
    Q_DECLARE_TR_FUNCTIONS(PadMap)
};

/// More than any gamepad has.
constexpr int kMostInputs = 64;

// A standard controller: the left stick's two axes, then the right one's, then the two triggers.
constexpr int kLeftX = 0;
constexpr int kLeftY = 1;
constexpr int kRightX = 2;
constexpr int kRightY = 3;
constexpr int kButtonA = 0;
constexpr int kButtonB = 1;
constexpr int kLeftShoulder = 9;
constexpr int kRightShoulder = 10;

constexpr PadInput axis(int index, bool reversed) {
    return {PadInput::Kind::Axis, index, reversed};
}

constexpr PadInput button(int index) {
    return {PadInput::Kind::Button, index, false};
}

QString code(const PadInput& input) {
    switch (input.kind) {
        case PadInput::Kind::Axis:
            return QStringLiteral("a%1%2").arg(input.index).arg(input.reversed ? QChar(u'-') : QChar(u'+'));
        case PadInput::Kind::Button:
            return QStringLiteral("b%1").arg(input.index);
        case PadInput::Kind::None:
            break;
    }
    return QStringLiteral("-");
}

bool decode(const QString& text, PadInput& input) {
    input = {};
    if (text == u"-") return true;
    const bool isAxis = text.startsWith(u'a');
    if (!isAxis && !text.startsWith(u'b')) return false;
    QString number = text.mid(1);
    if (isAxis) {
        if (!number.endsWith(u'+') && !number.endsWith(u'-')) return false;
        input.reversed = number.endsWith(u'-');
        number.chop(1);
    }
    bool isNumber = false;
    input.index = number.toInt(&isNumber);
    input.kind = isAxis ? PadInput::Kind::Axis : PadInput::Kind::Button;
    return isNumber && input.index >= 0 && input.index < kMostInputs;
}

QString knownAxis(int index, bool reversed) {
    switch (index) {
        case kLeftX:
            return reversed ? PadText::tr("left stick to the left") : PadText::tr("left stick to the right");
        case kLeftY:
            return reversed ? PadText::tr("left stick up") : PadText::tr("left stick down");
        case kRightX:
            return reversed ? PadText::tr("right stick to the left")
                            : PadText::tr("right stick to the right");
        case kRightY:
            return reversed ? PadText::tr("right stick up") : PadText::tr("right stick down");
        case 4:
            return PadText::tr("left trigger");
        case 5:
            return PadText::tr("right trigger");
        default:
            return {};
    }
}

QString knownButton(int index) {
    const QStringList names{QStringLiteral("A"),
                            QStringLiteral("B"),
                            QStringLiteral("X"),
                            QStringLiteral("Y"),
                            PadText::tr("Back"),
                            PadText::tr("Guide"),
                            PadText::tr("Start"),
                            PadText::tr("left stick pressed"),
                            PadText::tr("right stick pressed"),
                            PadText::tr("left shoulder"),
                            PadText::tr("right shoulder"),
                            PadText::tr("pad up"),
                            PadText::tr("pad down"),
                            PadText::tr("pad left"),
                            PadText::tr("pad right")};
    return names.value(index);
}

}  // namespace

double valueOf(const PadState& state, const PadInput& input) {
    const auto index = static_cast<std::size_t>(input.index);
    if (input.kind == PadInput::Kind::Button)
        return index < state.buttons.size() && state.buttons[index] ? 1 : 0;
    if (input.kind != PadInput::Kind::Axis || index >= state.axes.size()) return 0;
    return input.reversed ? -state.axes[index] : state.axes[index];
}

PadMap::PadMap()
    : inputs_{axis(kLeftY, true),     axis(kLeftX, true),    axis(kRightX, true),
              axis(kLeftY, true),     axis(kRightY, true),   button(kButtonA),
              button(kRightShoulder), button(kLeftShoulder), button(kButtonB)} {}

void PadMap::setInput(PadAction action, const PadInput& input) {
    if (action != PadAction::Stop && input == this->input(PadAction::Stop)) return;
    if (!isStick(action)) {
        for (const PadAction other : kPadActions) {
            PadInput& own = inputs_[static_cast<std::size_t>(other)];
            if (!isStick(other) && own == input) own = {};
        }
    }
    inputs_[static_cast<std::size_t>(action)] = input;
}

QString PadMap::toText() const {
    QStringList codes;
    for (const PadInput& input : inputs_)
        codes << code(input);
    return codes.join(u' ');
}

bool PadMap::setText(const QString& text) {
    const QStringList codes = text.split(u' ');
    if (codes.size() != static_cast<qsizetype>(inputs_.size())) return false;
    std::array<PadInput, kPadActions.size()> inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!decode(codes[static_cast<qsizetype>(i)], inputs.at(i))) return false;
    }
    inputs_ = inputs;
    return true;
}

QString inputText(const PadInput& input, bool knownPad) {
    if (input.kind == PadInput::Kind::None) return PadText::tr("nothing");
    const bool isAxis = input.kind == PadInput::Kind::Axis;
    QString text;
    if (knownPad) text = isAxis ? knownAxis(input.index, input.reversed) : knownButton(input.index);
    if (!text.isEmpty()) return text;
    if (!isAxis) return PadText::tr("button %1").arg(input.index + 1);
    return input.reversed ? PadText::tr("axis %1, reversed").arg(input.index + 1)
                          : PadText::tr("axis %1").arg(input.index + 1);
}

QString actionText(PadAction action) {
    switch (action) {
        case PadAction::Forward:
            return PadText::tr("Forward");
        case PadAction::Left:
            return PadText::tr("To the left");
        case PadAction::Turn:
            return PadText::tr("Turn left");
        case PadAction::LeftWheels:
            return PadText::tr("Wheels 1, 2 forward");
        case PadAction::RightWheels:
            return PadText::tr("Wheels 3, 4 forward");
        case PadAction::Dribbler:
            return PadText::tr("Dribbler on, off");
        case PadAction::Kick:
            return PadText::tr("Kick");
        case PadAction::Chip:
            return PadText::tr("Chip");
        case PadAction::Stop:
            return PadText::tr("STOP");
    }
    return {};
}

}  // namespace kickstand::ui
