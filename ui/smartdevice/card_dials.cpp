#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

constexpr int kDials = 3;

}  // namespace

CardContent dialsCard(const CardValues& values) {
    CardContent content;
    for (int i = 0; i < kDials; ++i) {
        const std::string name = "pot" + std::to_string(i);
        content.columns.push_back(
            {{CardPart::Kind::Arc, Words::tr("dial %1").arg(i), values.text(name, 2), values.number(name)}});
    }
    return content;
}

}  // namespace kickstand::ui
