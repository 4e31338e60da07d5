#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

using Kind = CardPart::Kind;

}  // namespace

CardContent tagCard(const CardValues& values) {
    // The number means nothing while there is no tag.
    if (!values.isOn("detect_tag"))
        return {{{{Kind::Number, Words::tr("nothing near the reader"),
                   values.marked(Words::tr("no tag"), "detect_tag")}}}};
    const auto id = static_cast<std::uint32_t>(values.number("id").value_or(0));
    return {
        {{{Kind::Number, Words::tr("tag"), values.marked(QString::number(id), "id")},
          {Kind::Words, {}, Words::tr("0x%1").arg(id, 8, 16, QLatin1Char('0')), {}, -2, -2, Tone::Good}}}};
}

}  // namespace kickstand::ui
