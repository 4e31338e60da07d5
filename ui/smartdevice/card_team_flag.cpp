#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

constexpr int kLeds = 4;

using Kind = CardPart::Kind;

}  // namespace

CardContent teamFlagCard(const CardValues& values) {
    const bool enabled = values.isOn("mode");
    const bool blue = values.isOn("blue");
    const bool yellow = values.isOn("yellow");
    CardPart lamps{Kind::Lamps, {}, {}};
    int lit = 0;
    for (int i = 1; i <= kLeds; ++i) {
        const bool on = enabled && (blue || yellow) && values.isOn("led" + std::to_string(i));
        lit += on ? 1 : 0;
        lamps.lamps.push_back(
            {Words::tr("LED %1").arg(i), on, blue ? CardPart::Light::Blue : CardPart::Light::Yellow});
    }
    QString colour = Words::tr("no colour");
    if (blue && yellow)
        colour = Words::tr("blue and yellow");
    else if (blue)
        colour = Words::tr("blue");
    else if (yellow)
        colour = Words::tr("yellow");
    const QString state = enabled ? Words::tr("%1, %2 of 4 lit").arg(colour).arg(lit)
                                  : Words::tr("off (%1 chosen)").arg(colour);
    return {{{lamps, {Kind::Words, {}, values.marked(state, "mode")}}}};
}

}  // namespace kickstand::ui
