#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

constexpr int kSwitches = 3;

}  // namespace

CardContent switchesCard(const CardValues& values) {
    CardPart lamps{CardPart::Kind::Lamps, {}, {}};
    for (int i = 0; i < kSwitches; ++i) {
        const std::string name = "switch" + std::to_string(i);
        const QString state = values.isOn(name) ? Words::tr("closed") : Words::tr("open");
        lamps.lamps.push_back({values.marked(Words::tr("%1 %2").arg(i).arg(state), name), values.isOn(name)});
    }
    return {{{lamps}}};
}

}  // namespace kickstand::ui
