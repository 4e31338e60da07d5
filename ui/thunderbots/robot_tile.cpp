#include "ui/thunderbots/robot_tile.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kSide = 8;
constexpr int kNumberSize = 28;
constexpr int kMotionTop = 32;
constexpr int kMotionHeight = 14;
constexpr int kReadingSize = 15;
constexpr int kLine = 18;
constexpr double kBarHeight = 3;
constexpr double kBarWidth = 64;
constexpr int kChipGap = 5;
constexpr double kBoltWidth = 9;
constexpr double kBoltHeight = 13;

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

/// As many whole words of a list as there is room for; what is no list is cut.
QString fitting(const QString& text, const QFontMetrics& metrics, int width) {
    QStringList words = text.split(QStringLiteral(" \u00b7 "));
    if (words.size() == 1 && metrics.horizontalAdvance(text) > width && text.contains(u' ')) {
        return metrics.elidedText(text, Qt::ElideRight, width);
    }
    while (!words.isEmpty() && metrics.horizontalAdvance(words.join(QStringLiteral(" \u00b7 "))) > width) {
        words.removeLast();
    }
    return words.join(QStringLiteral(" \u00b7 "));
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
    painter.setFont(numberFont(kNumberSize, QFont::DemiBold));
    painter.setPen(content_.live ? t.text : t.muted);
    painter.drawText(QRectF(kSide, 3, width() / 2.0, 30), Qt::AlignLeft | Qt::AlignVCenter,
                     QString::number(content_.robot));
    painter.setFont(textFont(metrics::kSmallTextSize, content_.moving ? QFont::DemiBold : QFont::Normal));
    painter.setPen(content_.moving ? t.text : t.muted);
    painter.drawText(QRectF(kSide, kMotionTop, width() / 2.0, kMotionHeight),
                     Qt::AlignLeft | Qt::AlignVCenter, content_.motion);
    paintReadings(painter);
    paintState(painter);
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
    if (!hasFocus() || !window()->testAttribute(Qt::WA_KeyboardFocusChange)) return;
    painter.setPen(QPen(t.accent, 1, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(3.5, 3.5, -3.5, -3.5), 4, 4);
}

void RobotTile::paintReadings(QPainter& painter) const {
    const Tokens& t = tokensOf(palette());
    const double right = width() - kSide;
    const double top = height() >= 76 ? 6 : 3;
    const QColor quiet = content_.live && !content_.stale ? t.text : t.muted;
    painter.setPen(quiet);
    if (!content_.known) {
        painter.setFont(numberFont(kReadingSize));
        painter.drawText(QRectF(0, top, right, kLine), Qt::AlignRight | Qt::AlignVCenter,
                         QStringLiteral("\u2014"));
        return;
    }
    const auto line = [&](double y, const QString& text, const QColor& ink, bool strong, double end) {
        painter.setFont(numberFont(kReadingSize, strong ? QFont::DemiBold : QFont::Normal));
        painter.setPen(ink);
        painter.drawText(QRectF(0, y, end, kLine), Qt::AlignRight | Qt::AlignVCenter, text);
    };
    const auto bar = [&](double y, const Level& level, const QColor& ink) {
        drawLevel(painter, QRectF(right - kBarWidth, y, kBarWidth, kBarHeight), level, ink, t.line,
                  content_.chosen ? t.accentSoft : t.surface);
    };
    const bool warned = content_.batteryWeight == TileContent::Weight::Warning;
    line(top, content_.battery, warned ? t.warn : quiet, warned, right);
    const double second = top + kLine + (content_.stale ? 0 : 6);
    const bool danger = content_.capacitorLive;
    line(second, content_.capacitor, danger ? t.danger : quiet, danger,
         danger ? right - kBoltWidth - 3 : right);
    if (danger) {
        drawBolt(painter,
                 QRectF(right - kBoltWidth, second + (kLine - kBoltHeight) / 2, kBoltWidth, kBoltHeight),
                 t.danger);
    }
    if (content_.stale) return;
    bar(top + kLine + 1, {content_.batteryLevel, kBatteryEmptyMark, kBatteryLowMark}, warned ? t.warn : t.ok);
    bar(second + kLine + 1, {content_.capacitorLevel, kCapacitorLiveMark, kCapacitorChargedMark},
        danger ? t.danger : t.muted);
}

QRectF RobotTile::stateArea() const {
    return QRectF(rect()).adjusted(kSide, 0, -kSide, -4);
}

void RobotTile::paintState(QPainter& painter) const {
    const Tokens& t = tokensOf(palette());
    const QFont font = textFont(metrics::kSmallTextSize);
    const QRectF area = stateArea();
    double x = area.left();
    for (const TileContent::Chip& chip : content_.chips) {
        const QSizeF size = chipSize(chip.text, font);
        const Inks inks = inksOf(chip.weight, t);
        if (size.width() > area.width()) {
            // A sentence: two lines.
            const QRectF box(area.left(), area.bottom() - 2 * size.height() + 4, area.width(),
                             2 * size.height() - 4);
            drawChip(painter, box, {}, font, inks.fill, inks.ink);
            painter.setPen(inks.ink);
            painter.setFont(font);
            painter.drawText(box.adjusted(5, 0, -2, 0), Qt::AlignVCenter | Qt::TextWordWrap, chip.text);
            return;
        }
        drawChip(painter, QRectF(x, area.bottom() - size.height(), size.width(), size.height()), chip.text,
                 font, inks.fill, inks.ink);
        x += size.width() + kChipGap;
    }
    painter.setFont(font);
    painter.setPen(t.muted);
    const QRectF rest(x, area.bottom() - 16, area.right() - x, 16);
    painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft,
                     fitting(content_.state, painter.fontMetrics(), static_cast<int>(rest.width())));
}

}  // namespace kickstand::ui
