#include "ui/plot/curve_colours.h"

#include <array>

namespace kickstand::ui {

namespace {

constexpr QRgb kBlack = 0xff1b1e23;
constexpr QRgb kWhite = 0xffe7eaee;
constexpr QRgb kOrange = 0xffe69f00;
constexpr QRgb kSkyBlue = 0xff56b4e9;
constexpr QRgb kGreen = 0xff009e73;
constexpr QRgb kYellow = 0xfff0e442;
constexpr QRgb kBlue = 0xff0072b2;
constexpr QRgb kVermillion = 0xffd55e00;
constexpr QRgb kPurple = 0xffcc79a7;

// Yellow cannot be seen on white, nor blue on black.
constexpr std::array<QRgb, kCurveColours> kOnLight{kBlue,    kVermillion, kGreen, kPurple,
                                                   kSkyBlue, kOrange,     kBlack};
constexpr std::array<QRgb, kCurveColours> kOnDark{kSkyBlue, kOrange,     kGreen, kPurple,
                                                  kYellow,  kVermillion, kWhite};

}  // namespace

QColor curveColour(int index, bool dark) {
    const auto at = static_cast<std::size_t>(index) % kCurveColours;
    return QColor(dark ? kOnDark[at] : kOnLight[at]);
}

std::vector<int> colourIndices(const std::vector<std::uint16_t>& units) {
    std::array<int, kCurveColours> used{};
    std::vector<int> colours;
    colours.reserve(units.size());
    for (const std::uint16_t unit : units) {
        int best = unit % kCurveColours;
        // The next one that is used least.
        for (int step = 1; step < kCurveColours; ++step) {
            const int next = (unit + step) % kCurveColours;
            if (used[static_cast<std::size_t>(next)] < used[static_cast<std::size_t>(best)]) best = next;
        }
        ++used[static_cast<std::size_t>(best)];
        colours.push_back(best);
    }
    return colours;
}

}  // namespace kickstand::ui
