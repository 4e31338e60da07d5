#include <QCoreApplication>
#include <algorithm>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

/// Less light than this in all three is no tape.
constexpr double kFaintest = 0.2;
/// So far from the middle, from -1 to 1, the tape is at one side.
constexpr double kAside = 0.25;

using Kind = CardPart::Kind;

CardPart brightness(const CardValues& values, const char* name, const QString& caption) {
    return {Kind::Level, caption, values.text(name, 2), values.number(name)};
}

QString placeText(const CardValues& values) {
    const double left = values.number("left").value_or(0);
    const double centre = values.number("center").value_or(0);
    const double right = values.number("right").value_or(0);
    const double all = left + centre + right;
    if (std::max({left, centre, right}) < kFaintest || all <= 0) return Words::tr("no tape");
    const double place = (right - left) / all;
    if (place < -kAside) return Words::tr("tape at the left");
    return place > kAside ? Words::tr("tape at the right") : Words::tr("tape in the middle");
}

}  // namespace

CardContent lineFollowerCard(const CardValues& values) {
    return {{{brightness(values, "left", Words::tr("left")),
              brightness(values, "center", Words::tr("centre")),
              brightness(values, "right", Words::tr("right")),
              {Kind::Words, {}, values.marked(placeText(values), "center")}}}};
}

}  // namespace kickstand::ui
