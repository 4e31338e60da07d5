#include <QCoreApplication>
#include <algorithm>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

/// As many as there is room for.
constexpr std::size_t kMost = 5;

}  // namespace

CardContent plainCard(const CardValues& values) {
    const smartdevice::DeviceState& device = values.device();
    std::vector<CardPart> parts;
    const std::size_t count = device.spec->parameters.size();
    for (std::size_t i = 0; i < std::min(count, kMost); ++i) {
        const smartdevice::ParameterSpec& spec = device.spec->parameters[i];
        const auto& value = device.parameters[i].value;
        const QString text = value ? values.marked(withUnit(valueText(*value, spec), spec), spec.name)
                                   : QStringLiteral("\u2014");
        parts.push_back({CardPart::Kind::Words, QString::fromStdString(spec.name), text});
    }
    if (count > kMost)
        parts.back() = {CardPart::Kind::Words,
                        Words::tr("and %n more", nullptr, static_cast<int>(count - kMost + 1)),
                        {}};
    if (parts.empty())
        parts.push_back(
            {CardPart::Kind::Words,
             device.learning ? Words::tr("its parameters are being found out") : Words::tr("no parameters"),
             {}});
    return {{parts}};
}

}  // namespace kickstand::ui
