#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

constexpr double kTicksPerTurn = 4400;

using Kind = CardPart::Kind;

}  // namespace

CardContent encoderCard(const CardValues& values) {
    CardPart angle{Kind::Turn, {}, {}};
    QString turns = QStringLiteral("\u2014");
    if (const auto ticks = values.number("rotation")) {
        angle.value = *ticks / kTicksPerTurn;
        turns = values.marked(Words::tr("%1 turns").arg(numberText(*angle.value, 2)), "rotation");
    }
    return {{{angle}, {{Kind::Number, turns, values.text("rotation", 0)}}}};
}

}  // namespace kickstand::ui
