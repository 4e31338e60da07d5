#include <QCoreApplication>
#include <algorithm>
#include <array>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

/// The scales, V: a battery of three cells, and one of them.
constexpr double kEmpty_V = 9;
constexpr double kFull_V = 12.6;
constexpr double kSafeFrom_V = 10.5;
constexpr double kSafeTo_V = 12;
constexpr double kCells = 3;

using Kind = CardPart::Kind;

double part(double volts, double cells) {
    return (volts * kCells / cells - kEmpty_V) / (kFull_V - kEmpty_V);
}

}  // namespace

CardContent batteryCard(const CardValues& values) {
    const bool unsafe = values.isOn("is_unsafe");
    CardPart whole{Kind::Level, Words::tr("10.5 to 12 V is safe"), {}};
    whole.low = part(kSafeFrom_V, kCells);
    whole.high = part(kSafeTo_V, kCells);
    whole.tone = unsafe ? Tone::Danger : Tone::Good;
    if (const auto volts = values.number("v_batt")) whole.value = part(*volts, kCells);
    CardPart alarm{Kind::Words, {}, QStringLiteral("\u2014")};
    if (values.number("is_unsafe")) {
        alarm.text = values.marked(unsafe ? Words::tr("alarm: unsafe") : Words::tr("safe"), "is_unsafe");
        alarm.tone = unsafe ? Tone::Danger : Tone::Good;
    }
    std::vector<CardPart> cells;
    // The taps are counted from the negative end: the first cell is the first tap.
    constexpr std::array kCellNames{"v_cell1", "dv_cell2", "dv_cell3"};
    double least = kFull_V;
    double most = 0;
    bool known = true;
    for (std::size_t i = 0; i < kCellNames.size(); ++i) {
        CardPart cell{Kind::Level, Words::tr("cell %1").arg(i + 1), values.text(kCellNames[i], 2)};
        if (const auto volts = values.number(kCellNames[i])) {
            cell.value = part(*volts, 1);
            least = std::min(least, *volts);
            most = std::max(most, *volts);
        } else {
            known = false;
        }
        cells.push_back(std::move(cell));
    }
    CardPart calibrated{Kind::Words, {}, QStringLiteral("\u2014")};
    if (values.number("calibrated")) {
        const bool is = values.isOn("calibrated");
        calibrated.text =
            values.marked(is ? Words::tr("calibrated") : Words::tr("not calibrated"), "calibrated");
        calibrated.tone = is ? Tone::Good : Tone::Warning;
    }
    const QString apart = known
                              ? values.marked(Words::tr("%1 V").arg(numberText(most - least, 2)), "dv_cell3")
                              : QStringLiteral("\u2014");
    cells.push_back({Kind::Words, Words::tr("apart"), apart});
    return {
        {{{Kind::Number, Words::tr("battery"), values.text("v_batt", 2)}, whole, alarm, calibrated}, cells}};
}

}  // namespace kickstand::ui
