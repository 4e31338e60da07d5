#include "ui/thunderbots/robot_tile.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include "ui/thunderbots/tile_layout.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kLine = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip;
constexpr double kChipInset = 3;
constexpr double kOddWidth = 3;
constexpr double kOddInset = 10;

struct Inks {
    QColor fill;
    QColor ink;
};

Inks inksOf(TileContent::Weight weight, const Tokens& t) {
    switch (weight) {
        case TileContent::Weight::Warning:
            return {t.warnSoft, t.warn};
        case TileContent::Weight::Danger:
            return {t.dangerSoft, t.danger};
        case TileContent::Weight::Accent:
            return {t.accentSoft, t.accent};
        case TileContent::Weight::Plain:
            break;
    }
    return {t.grid, t.text};
}

/// A ball; a roller seen from its end.
void drawSign(QPainter& painter, TileContent::Sign sign, const QRectF& box, const QColor& ink) {
    const QRectF disc = box.adjusted(1, 1, -1, -1);
    if (sign == TileContent::Sign::Ball) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(disc);
        return;
    }
    painter.setPen(QPen(ink, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(disc, 30 * 16, 300 * 16);
    painter.setBrush(ink);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(disc.center(), 1.5, 1.5);
}

void drawDownMark(QPainter& painter, const QRectF& box, const QColor& ink) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPolygon(QPolygonF{{box.topLeft(), box.topRight(), {box.center().x(), box.bottom()}}});
}

/// Waves from an antenna; struck through where nothing is heard any more.
void drawRadio(QPainter& painter, const QRectF& box, bool heard, const QColor& ink) {
    const QPointF foot(box.center().x(), box.bottom() - 1.5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawEllipse(foot, 1.5, 1.5);
    painter.setPen(QPen(ink, 1.25, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    for (const double radius : {4.0, 7.0}) {
        const QSizeF size(2 * radius, 2 * radius);
        painter.drawArc(QRectF(foot - QPointF(radius, radius), size), 45 * 16, 90 * 16);
    }
    if (!heard) painter.drawLine(box.topRight(), box.bottomLeft());
}

}  // namespace

RobotTile::RobotTile(int robot, QWidget* parent) : QAbstractButton(parent) {
    content_.robot = robot;
    setObjectName(QStringLiteral("robot%1").arg(robot));
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    connect(this, &QAbstractButton::clicked, this, [this] { emit picked(content_.robot, Qt::NoModifier); });
}

void RobotTile::setContent(TileContent content) {
    setChecked(content.chosen);
    if (content == content_) return;
    content_ = std::move(content);
    setAccessibleName(content_.accessible);
    update();
}

bool RobotTile::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) emit tipWanted(content_.robot);
    return QAbstractButton::event(event);
}

void RobotTile::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit picked(content_.robot, event->modifiers());
}

void RobotTile::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
            emit picked(content_.robot, event->modifiers());
            return;
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Home:
        case Qt::Key_End:
            emit stepped(content_.robot, event->key(), event->modifiers());
            return;
        default:
            QAbstractButton::keyPressEvent(event);
    }
}

void RobotTile::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintFrame(painter);
    const Tokens& t = tokensOf(palette());
    const TileLayout places = layOutTile(content_, size());
    painter.setFont(tileNumberFont());
    painter.setPen(content_.live ? t.text : t.muted);
    painter.drawText(places.number, kLine, QString::number(content_.robot));
    if (!places.radio.isNull())
        drawRadio(painter, places.radio, content_.live, content_.live ? t.ok : t.muted);
    const bool strong = content_.moving || !content_.oddBy.isEmpty();
    painter.setFont(tileWordFont(strong));
    painter.setPen(strong ? t.text : t.muted);
    painter.drawText(places.motion, kLine, content_.motion);
    paintReadings(painter, places);
    paintState(painter, places);
}

void RobotTile::paintFrame(QPainter& painter) const {
    const Tokens& t = tokensOf(palette());
    QPen border(underMouse() ? t.muted : t.line, 1);
    if (!content_.live) border.setStyle(Qt::DashLine);
    if (content_.chosen) border = QPen(t.accent, 2);
    const double inset = border.widthF() / 2;
    painter.setPen(border);
    painter.setBrush(content_.chosen ? t.accentSoft : t.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), metrics::kControlRadius,
                            metrics::kControlRadius);
    if (!content_.oddBy.isEmpty()) {
        painter.fillRect(QRectF(2, kOddInset, kOddWidth, height() - 2 * kOddInset), t.text);
    }
    if (!hasFocus() || !window()->testAttribute(Qt::WA_KeyboardFocusChange)) return;
    painter.setPen(QPen(t.accent, 1, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(3.5, 3.5, -3.5, -3.5), 4, 4);
}

void RobotTile::paintReadings(QPainter& painter, const TileLayout& places) const {
    const Tokens& t = tokensOf(palette());
    const QColor quiet = content_.live && !content_.stale ? t.text : t.muted;
    if (!content_.known) {
        painter.setFont(tileReadingFont(false));
        painter.setPen(quiet);
        painter.drawText(QRectF(places.number.topRight(), QPointF(width() - 8.0, places.number.bottom())),
                         Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("\u2014"));
        return;
    }
    const auto text = [&painter](const QRectF& box, const QString& words, const QFont& font,
                                 const QColor& ink) {
        painter.setFont(font);
        painter.setPen(ink);
        painter.drawText(box, kLine, words);
    };
    const bool warned = content_.batteryWeight == TileContent::Weight::Warning;
    const QColor batteryInk = warned ? t.warn : quiet;
    text(places.battery, content_.battery, tileReadingFont(warned), batteryInk);
    if (!places.batteryWord.isNull())
        text(places.batteryWord, content_.batteryWord, tileWordFont(false), batteryInk);
    const bool danger = content_.capacitorLive;
    text(places.capacitor, content_.capacitor, tileReadingFont(danger), danger ? t.danger : quiet);
    if (danger) drawBolt(painter, places.bolt, t.danger);
    if (content_.stale) return;
    const QColor ground = content_.chosen ? t.accentSoft : t.surface;
    drawLevel(painter, places.batteryBar, {content_.batteryLevel, kBatteryEmptyMark, kBatteryLowMark},
              warned ? t.warn : t.ok, t.line, ground);
    drawLevel(painter, places.capacitorBar,
              {content_.capacitorLevel, kCapacitorLiveMark, kCapacitorChargedMark},
              danger ? t.danger : t.muted, t.line, ground);
    if (content_.lowestBattery) drawDownMark(painter, places.lowestMark, warned ? t.warn : t.text);
}

void RobotTile::paintState(QPainter& painter, const TileLayout& places) const {
    const Tokens& t = tokensOf(palette());
    const QFont font = tileWordFont(false);
    for (std::size_t i = 0; i < places.chips.size(); ++i) {
        const TileLayout::ChipBox& place = places.chips[i];
        const TileContent::Chip& chip = content_.chips[i];
        const Inks inks = inksOf(chip.weight, t);
        if (place.lines.isEmpty()) {
            drawSign(painter, chip.sign, place.box, inks.ink);
            continue;
        }
        drawChip(painter, place.box, {}, font, inks.fill, inks.ink);
        painter.setFont(font);
        painter.setPen(inks.ink);
        const double height = place.box.height() / static_cast<double>(place.lines.size());
        for (qsizetype line = 0; line < place.lines.size(); ++line) {
            painter.drawText(
                QRectF(place.box.left() + kChipInset, place.box.top() + static_cast<double>(line) * height,
                       place.box.width(), height),
                kLine, place.lines[line]);
        }
    }
    painter.setFont(font);
    painter.setPen(t.muted);
    painter.drawText(places.state, kLine, places.stateText);
}

}  // namespace kickstand::ui
