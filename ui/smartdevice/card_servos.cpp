#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

constexpr int kServos = 2;

}  // namespace

CardContent servosCard(const CardValues& values) {
    CardContent content;
    for (int i = 0; i < kServos; ++i) {
        const std::string name = "servo" + std::to_string(i);
        CardPart servo{CardPart::Kind::Arc, Words::tr("servo %1").arg(i), values.text(name, 2)};
        // From one end of the travel to the other.
        if (const auto place = values.number(name)) servo.value = (*place + 1) / 2;
        content.columns.push_back({servo});
    }
    return content;
}

}  // namespace kickstand::ui
