#include "ui/thunderbots/leds_lights.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kRadius = 12;
constexpr int kHeight = 66;
constexpr int kLeastPitch = 44;
constexpr int kTop = 2;
/// The colour of the lights themselves, the same in both themes.
constexpr QRgb kLit = 0xFFFFB000;
constexpr QRgb kLitEdge = 0xFFB87800;

}  // namespace

LedLights::LedLights(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("lights"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setMode({});
}

void LedLights::setMode(const thunderbots::wire::TestMode& mode) {
    meanings_ = ledMeanings(mode);
    QStringList words;
    for (std::size_t led = 0; led < meanings_.size(); ++led) {
        const QString text = meanings_[led].text;
        words << tr("LED %1: %2").arg(led).arg(text.isEmpty() ? tr("not used") : text);
    }
    setAccessibleName(words.join(QStringLiteral("; ")));
    update();
}

QSize LedLights::sizeHint() const {
    return {4 * kLeastPitch, kHeight};
}

double LedLights::centreOf(std::size_t led) const {
    const double pitch = width() / static_cast<double>(meanings_.size());
    return pitch * (static_cast<double>(led) + 0.5);
}

void LedLights::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    for (std::size_t led = 0; led < meanings_.size(); ++led) {
        const LedMeaning& meaning = meanings_[led];
        const QPointF centre(centreOf(led), kTop + kRadius);
        const bool used = meaning.kind != LedMeaning::Kind::Unused;
        painter.setPen(used ? QPen(QColor(kLitEdge), 2) : QPen(t.line, 2, Qt::DotLine));
        painter.setBrush(t.background);
        painter.drawEllipse(centre, kRadius, kRadius);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(kLit));
        if (meaning.kind == LedMeaning::Kind::On) {
            painter.drawEllipse(centre, kRadius - 1, kRadius - 1);
        } else if (used) {
            // Half lit: whether it is on, only the robot shows.
            const QRectF light(centre - QPointF(kRadius - 1, kRadius - 1),
                               QSizeF(2 * kRadius - 2, 2 * kRadius - 2));
            painter.drawPie(light, 90 * 16, 180 * 16);
        }
        const QRectF below(centre.x() - kLeastPitch, kTop + 2 * kRadius + 4, 2 * kLeastPitch, 18);
        painter.setFont(textFont(metrics::kTextSize, QFont::DemiBold));
        painter.setPen(used ? t.text : t.muted);
        painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter,
                         used ? meaning.mark : QStringLiteral("\u2014"));
        painter.setFont(numberFont(metrics::kSmallTextSize));
        painter.setPen(t.muted);
        painter.drawText(below.translated(0, 18), Qt::AlignHCenter | Qt::AlignVCenter, tr("LED %1").arg(led));
    }
}

bool LedLights::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int pitch = std::max(1, width() / 4);
    const auto led = static_cast<std::size_t>(std::clamp(help->pos().x() / pitch, 0, 3));
    QToolTip::showText(help->globalPos(),
                       meanings_[led].text.isEmpty() ? tr("Not used in this mode") : meanings_[led].text,
                       this);
    return true;
}

}  // namespace kickstand::ui
