#include "ui/thunderbots/tile_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kSide = 8;
constexpr double kGap = 4;
constexpr int kNumberSize = 28;
constexpr double kNumberHeight = 26;
constexpr int kReadingSize = 15;
constexpr double kReadingHeight = 16;
constexpr double kBarWidth = 60;
constexpr double kBarHeight = 3;
constexpr double kBarGap = 1;
constexpr double kMotionHeight = 14;
constexpr QSizeF kRadio(11, 10);
constexpr QSizeF kMark(8, kBarHeight + 2 * kBarGap);
constexpr double kBoltWidth = 9;
constexpr double kBoltHeight = 13;
constexpr double kChipHeight = 16;
constexpr double kChipLine = 12;
constexpr double kChipPadding = 3;
constexpr double kSignSize = 10;
/// From this height on there is air above.
constexpr double kRoomy = 76;

double widthOf(const QString& text, const QFont& font) {
    return std::ceil(QFontMetricsF(font).horizontalAdvance(text));
}

double chipWidth(const QString& text) {
    return widthOf(text, tileWordFont(false)) + 2 * kChipPadding;
}

/// Two lines: parted at the colon where both parts fit, else as full as the first one gets.
QStringList sentenceLines(const QString& text, double room) {
    const qsizetype colon = text.indexOf(QStringLiteral(": "));
    if (colon > 0 && chipWidth(text.left(colon + 1)) <= room)
        return {text.left(colon + 1), text.mid(colon + 2)};
    QStringList lines{QString()};
    for (const QString& word : text.split(u' ')) {
        const QString longer = lines.back().isEmpty() ? word : lines.back() + u' ' + word;
        if (lines.size() < 2 && chipWidth(longer) > room) {
            lines.append(word);
        } else {
            lines.back() = longer;
        }
    }
    return lines;
}

/// Lays one tile out, from the top to the bottom.
class Layouter {
  public:
    Layouter(const TileContent& content, const QSizeF& size) : content_(content), size_(size) {}

    TileLayout run() && {
        placeLeft();
        if (content_.known) placeReadings();
        if (!placeSentence()) placeChips();
        placeState();
        return std::move(out_);
    }

  private:
    double left() const { return kSide; }
    double right() const { return size_.width() - kSide; }
    double top() const { return size_.height() >= kRoomy ? 5 : 2; }
    double bottom() const { return size_.height() - 4; }

    void placeLeft() {
        const double width = widthOf(QString::number(content_.robot), tileNumberFont());
        out_.number = {left(), top(), width, kNumberHeight};
        if (content_.live || content_.known) {
            out_.radio = {QPointF(out_.number.right() + kGap, out_.number.bottom() - kRadio.height()),
                          kRadio};
        }
        if (content_.motion.isEmpty()) return;
        out_.motion = {left(), top() + kNumberHeight, widthOf(content_.motion, tileWordFont(true)),
                       kMotionHeight};
    }

    void placeBattery(double y) {
        const bool warned = content_.batteryWeight == TileContent::Weight::Warning;
        const double battery = widthOf(content_.battery, tileReadingFont(warned));
        double end = right();
        if (!content_.batteryWord.isEmpty()) {
            const double width = widthOf(content_.batteryWord, tileWordFont(false));
            // "lowest" has its mark as well: with wide digits the word is left out.
            if (warned || end - width - 3 - battery >= out_.number.right() + kGap) {
                out_.batteryWord = {end - width, y, width, kReadingHeight};
                end -= width + 3;
            }
        }
        out_.battery = {end - battery, y, battery, kReadingHeight};
    }

    void placeReadings() {
        double y = top();
        placeBattery(y);
        y += kReadingHeight + kBarGap;
        if (!content_.stale) {
            out_.batteryBar = {right() - kBarWidth, y, kBarWidth, kBarHeight};
            y += kBarHeight + kBarGap;
        }
        if (content_.lowestBattery) {
            const double bar = right() - kBarWidth;
            out_.lowestMark = {QPointF(bar - 3 - kMark.width(), out_.batteryBar.top() - kBarGap), kMark};
        }
        double end = right();
        if (content_.capacitorLive) {
            out_.bolt = {end - kBoltWidth, y + (kReadingHeight - kBoltHeight) / 2, kBoltWidth, kBoltHeight};
            end -= kBoltWidth + 3;
        }
        const double capacitor = widthOf(content_.capacitor, tileReadingFont(content_.capacitorLive));
        out_.capacitor = {end - capacitor, y, capacitor, kReadingHeight};
        y += kReadingHeight + kBarGap;
        if (!content_.stale) out_.capacitorBar = {right() - kBarWidth, y, kBarWidth, kBarHeight};
    }

    /// A chip that is a sentence has the whole width, on two lines where it needs them.
    bool placeSentence() {
        if (content_.chips.size() != 1) return false;
        const QString& text = content_.chips.front().text;
        const double room = right() - left();
        if (chipWidth(text) <= room) return false;
        const double height = 2 * kChipLine + 1;
        out_.chips.push_back({{left(), bottom() - height, room, height}, sentenceLines(text, room)});
        nextX_ = right();
        return true;
    }

    void placeChips() {
        std::vector<bool> words(content_.chips.size(), true);
        const auto total = [&] {
            double sum = 0;
            for (std::size_t i = 0; i < words.size(); ++i)
                sum += (words[i] ? chipWidth(content_.chips[i].text) : kSignSize) + (i > 0 ? kGap : 0);
            return sum;
        };
        // Those with a sign give up their word first, the last of them before the others.
        for (std::size_t i = words.size(); i > 0 && total() > right() - left(); --i) {
            if (content_.chips[i - 1].sign != TileContent::Sign::None) words[i - 1] = false;
        }
        nextX_ = left();
        double motionX = out_.motion.isNull() ? left() : out_.motion.right() + kGap;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const QString& text = content_.chips[i].text;
            const double width = words[i] ? chipWidth(text) : kSignSize;
            if (!words[i] && nextX_ + width > right()) {
                // The bottom line is full: beside what the robot was told to do.
                out_.chips.push_back(
                    {{motionX, top() + kNumberHeight + (kMotionHeight - kSignSize) / 2, width, kSignSize},
                     {}});
                motionX += width + kGap;
                continue;
            }
            const double height = words[i] ? kChipHeight : kSignSize;
            const double y = bottom() - kChipHeight + (kChipHeight - height) / 2;
            out_.chips.push_back({{nextX_, y, width, height}, words[i] ? QStringList{text} : QStringList{}});
            nextX_ += width + kGap;
        }
    }

    void placeState() {
        const double room = right() - nextX_;
        if (content_.state.isEmpty() || room <= 0) return;
        const QFont font = tileWordFont(false);
        const bool whole = content_.stateShort.isEmpty() || widthOf(content_.state, font) <= room;
        const QString& text = whole ? content_.state : content_.stateShort;
        // Without its end a word like "now" says nothing.
        if (!whole && widthOf(text, font) > room) return;
        out_.stateText = QFontMetricsF(font).elidedText(text, Qt::ElideRight, room);
        out_.state = {nextX_, bottom() - kChipHeight, room, kChipHeight};
    }

    const TileContent& content_;
    QSizeF size_;
    TileLayout out_;
    double nextX_ = kSide;  ///< Where there is room on the bottom line.
};

}  // namespace

std::vector<std::pair<QString, QRectF>> TileLayout::parts() const {
    std::vector<std::pair<QString, QRectF>> parts;
    const auto add = [&parts](const char* name, const QRectF& box) {
        if (!box.isEmpty()) parts.emplace_back(QString::fromLatin1(name), box);
    };
    add("number", number);
    add("radio", radio);
    add("motion", motion);
    add("battery", battery);
    add("battery word", batteryWord);
    add("battery bar", batteryBar);
    add("lowest mark", lowestMark);
    add("capacitor", capacitor);
    add("bolt", bolt);
    add("capacitor bar", capacitorBar);
    add("state", state);
    for (const ChipBox& chip : chips)
        add("chip", chip.box);
    return parts;
}

QFont tileNumberFont() {
    return numberFont(kNumberSize, QFont::DemiBold);
}

QFont tileReadingFont(bool strong) {
    return numberFont(kReadingSize, strong ? QFont::DemiBold : QFont::Normal);
}

QFont tileWordFont(bool strong) {
    return textFont(metrics::kSmallTextSize, strong ? QFont::DemiBold : QFont::Normal);
}

TileLayout layOutTile(const TileContent& content, const QSizeF& size) {
    return Layouter(content, size).run();
}

}  // namespace kickstand::ui
