#include "ui/smartdevice/card_painter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

using Kind = CardPart::Kind;

constexpr double kColumnGap = 16;
constexpr double kRowGap = 4;
constexpr double kLine = 16;
constexpr double kBar = 6;
constexpr double kNumber = 26;
constexpr double kLamp = 20;
constexpr double kTone = 9;
constexpr int kNumberSize = 20;
/// Where a sector begins and how far it goes, in degrees clockwise from the bottom.
constexpr double kSectorFrom = 45;
constexpr double kSector = 270;

class CardPainter {
  public:
    CardPainter(QPainter& painter, const Tokens& tokens, bool grey) : p_(painter), t_(tokens), grey_(grey) {}

    void column(QRectF area, const std::vector<CardPart>& parts) {
        for (const CardPart& part : parts) {
            const double height = heightOf(part, area.height());
            draw(part, QRectF(area.topLeft(), QSizeF(area.width(), height)));
            area.setTop(area.top() + height + kRowGap);
        }
    }

  private:
    static double heightOf(const CardPart& part, double room) {
        switch (part.kind) {
            case Kind::Number:
                return kNumber + kLine;
            case Kind::Level:
            case Kind::Centre:
                return kLine + kBar;
            case Kind::Arc:
            case Kind::Turn:
                return room;
            case Kind::Lamps:
                return kLamp + kLine + 4;
            case Kind::Words:
                return kLine;
        }
        return kLine;
    }

    QColor ink() const { return grey_ ? t_.muted : t_.text; }
    QColor fill(Tone tone) const {
        if (grey_) return t_.muted;
        return tone == Tone::Idle ? t_.accent : toneColour(tone, t_);
    }

    void draw(const CardPart& part, const QRectF& area) {
        switch (part.kind) {
            case Kind::Number:
                return number(part, area);
            case Kind::Level:
                line(part, area);
                return level(part, bar(area));
            case Kind::Centre:
                line(part, area);
                return centre(part, bar(area));
            case Kind::Arc:
                return dial(part, area, kSectorFrom, kSector);
            case Kind::Turn:
                return dial(part, area, 180, 360);
            case Kind::Lamps:
                return lamps(part, area);
            case Kind::Words:
                return line(part, area);
        }
    }

    void write(const QRectF& area, Qt::Alignment align, const QString& text, const QFont& font,
               const QColor& colour) {
        p_.setFont(font);
        p_.setPen(colour);
        p_.drawText(area, align | Qt::AlignVCenter | Qt::TextSingleLine,
                    QFontMetricsF(font).elidedText(text, Qt::ElideRight, area.width()));
    }

    void number(const CardPart& part, const QRectF& area) {
        write(QRectF(area.topLeft(), QSizeF(area.width(), kNumber)), Qt::AlignLeft, part.text,
              numberFont(kNumberSize, QFont::DemiBold), ink());
        write(QRectF(area.left(), area.top() + kNumber, area.width(), kLine), Qt::AlignLeft, part.caption,
              textFont(metrics::kSmallTextSize), t_.muted);
    }

    /// The caption at the left and the text at the right; without a caption the text with its shape.
    void line(const CardPart& part, const QRectF& area) {
        QRectF place(area.topLeft(), QSizeF(area.width(), kLine));
        if (part.caption.isEmpty()) {
            if (part.tone != Tone::Idle) {
                drawTone(p_, part.tone, QRectF(place.left(), place.center().y() - kTone / 2, kTone, kTone),
                         fill(part.tone));
                place.setLeft(place.left() + kTone + 6);
            }
            return write(place, Qt::AlignLeft, part.text, textFont(metrics::kSmallTextSize),
                         part.tone == Tone::Idle ? ink() : fill(part.tone));
        }
        const QFont font = numberFont(metrics::kSmallTextSize);
        const double taken = QFontMetricsF(font).horizontalAdvance(part.text);
        write(place, Qt::AlignRight, part.text, font, ink());
        place.setRight(place.right() - taken - 4);
        write(place, Qt::AlignLeft, part.caption, textFont(metrics::kSmallTextSize), t_.muted);
    }

    static QRectF bar(const QRectF& area) { return {area.left(), area.top() + kLine, area.width(), kBar}; }

    void level(const CardPart& part, const QRectF& place) {
        drawLevel(p_, place, {part.value.value_or(0), part.low, part.high}, fill(part.tone), t_.line,
                  t_.muted);
    }

    void centre(const CardPart& part, const QRectF& place) {
        p_.setPen(Qt::NoPen);
        p_.setBrush(t_.line);
        p_.drawRoundedRect(place, kBar / 2, kBar / 2);
        const auto at = [&](double value) {
            return place.left() + place.width() * (std::clamp(value, -1.0, 1.0) + 1) / 2;
        };
        const double value = part.value.value_or(0);
        if (value != 0) {
            p_.setBrush(fill(part.tone));
            p_.drawRect(QRectF(QPointF(std::min(at(0), at(value)), place.top()),
                               QPointF(std::max(at(0), at(value)), place.bottom())));
        }
        for (const double mark : {part.low, 0.0, part.high}) {
            if (mark < -1 || mark > 1) continue;
            p_.fillRect(QRectF(std::round(at(mark)), place.top() - 2, 1, kBar + 4), t_.muted);
        }
    }

    /// `from`: degrees clockwise from the bottom to where the track begins.
    void dial(const CardPart& part, const QRectF& area, double from, double sweep) {
        const double size = std::min(area.width(), area.height() - 2 * kLine) - 4;
        const QRectF place(area.center().x() - size / 2, area.top() + 2, size, size);
        const bool round = sweep >= 360;
        // Qt counts sixteenths of a degree, anticlockwise from three o'clock.
        const auto qt = [](double clockwise) { return static_cast<int>((270 - clockwise) * 16); };
        p_.setBrush(Qt::NoBrush);
        p_.setPen(QPen(t_.line, 5, Qt::SolidLine, Qt::RoundCap));
        p_.drawArc(place, qt(from), static_cast<int>(-sweep * 16));
        if (part.value) {
            const double share =
                round ? *part.value - std::floor(*part.value) : std::clamp(*part.value, 0.0, 1.0);
            const double angle = from + share * sweep;
            p_.setPen(QPen(fill(part.tone), 5, Qt::SolidLine, Qt::RoundCap));
            if (!round && share > 0) p_.drawArc(place, qt(from), static_cast<int>(-share * sweep * 16));
            const double radians = angle * std::numbers::pi / 180;
            const QPointF way(-std::sin(radians), std::cos(radians));
            const QPointF middle = place.center();
            p_.setPen(QPen(round ? fill(part.tone) : ink(), 2.5, Qt::SolidLine, Qt::RoundCap));
            p_.drawLine(middle, middle + way * (size / 2 - (round ? 1 : 6)));
            p_.setPen(Qt::NoPen);
            p_.setBrush(round ? fill(part.tone) : ink());
            p_.drawEllipse(middle, 3, 3);
        }
        QRectF text(area.left(), area.bottom() - 2 * kLine, area.width(), kLine);
        write(text, Qt::AlignHCenter, part.text, numberFont(metrics::kTextSize, QFont::DemiBold), ink());
        text.translate(0, kLine);
        write(text, Qt::AlignHCenter, part.caption, textFont(metrics::kSmallTextSize), t_.muted);
    }

    QColor lightOf(CardPart::Light light) const {
        if (grey_) return t_.muted;
        switch (light) {
            case CardPart::Light::Blue:
                return t_.accent;
            case CardPart::Light::Yellow:
                return t_.warn;
            case CardPart::Light::Plain:
                return t_.ok;
        }
        return t_.ok;
    }

    void lamps(const CardPart& part, const QRectF& area) {
        const double pitch = area.width() / std::max<double>(1, static_cast<double>(part.lamps.size()));
        double left = area.left();
        for (const CardPart::Lamp& lamp : part.lamps) {
            const QPointF middle(left + pitch / 2, area.top() + kLamp / 2 + 1);
            p_.setPen(QPen(lamp.lit ? lightOf(lamp.light) : t_.muted, 2));
            p_.setBrush(lamp.lit ? lightOf(lamp.light) : t_.background);
            p_.drawEllipse(middle, kLamp / 2 - 1, kLamp / 2 - 1);
            write(QRectF(left, area.top() + kLamp + 4, pitch, kLine), Qt::AlignHCenter, lamp.label,
                  textFont(metrics::kSmallTextSize), lamp.lit ? ink() : t_.muted);
            left += pitch;
        }
    }

    QPainter& p_;
    const Tokens& t_;
    bool grey_;
};

}  // namespace

void drawCard(QPainter& painter, const QRectF& area, const CardContent& content, const Tokens& tokens,
              bool grey) {
    if (content.columns.empty()) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto count = static_cast<double>(content.columns.size());
    const double width = (area.width() - (count - 1) * kColumnGap) / count;
    double left = area.left();
    for (const auto& column : content.columns) {
        CardPainter(painter, tokens, grey).column(QRectF(left, area.top(), width, area.height()), column);
        left += width + kColumnGap;
    }
    painter.restore();
}

}  // namespace kickstand::ui
