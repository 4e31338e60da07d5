#include "ui/widgets/banner.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kButtonHeight = 24;

QColor fillOf(Banner::Kind kind, const Tokens& t) {
    switch (kind) {
        case Banner::Kind::Notice:
            return t.accentSoft;
        case Banner::Kind::Warning:
            return t.warnSoft;
        case Banner::Kind::Danger:
            return t.dangerSoft;
    }
    return t.surface;
}

QColor inkOf(Banner::Kind kind, const Tokens& t) {
    switch (kind) {
        case Banner::Kind::Notice:
            return t.text;
        case Banner::Kind::Warning:
            return t.warn;
        case Banner::Kind::Danger:
            return t.danger;
    }
    return t.text;
}

}  // namespace

Banner::Banner(Kind kind, QWidget* parent)
    : QWidget(parent), kind_(kind), label_(new QLabel(this)), row_(new QHBoxLayout(this)) {
    row_->setContentsMargins(metrics::kPadding, 3, metrics::kPadding, 3);
    row_->setSpacing(metrics::kGap);
    row_->addWidget(label_, 1);
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::RichText);
    label_->setTextInteractionFlags(Qt::NoTextInteraction);
    // Not Fixed: that would bound it by what its words need at their favourite width, not at the one it has.
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    recolour();
}

void Banner::setText(const QString& strong, const QString& text) {
    if (strong == strong_ && text == text_) return;
    strong_ = strong;
    text_ = text;
    setAccessibleName(this->text());
    recolour();
}

QString Banner::text() const {
    return text_.isEmpty() ? strong_ : strong_ + QStringLiteral(" \u2014 ") + text_;
}

void Banner::setKind(Kind kind) {
    if (kind == kind_) return;
    kind_ = kind;
    recolour();
    update();
}

QPushButton* Banner::addButton(const QString& text) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    addTrailing(button);
    return button;
}

void Banner::addTrailing(QWidget* widget) {
    widget->setFixedHeight(kButtonHeight);
    row_->addWidget(widget);
}

void Banner::recolour() {
    const Tokens& t = tokensOf(palette());
    QString html = QStringLiteral("<span style=\"color:%1;font-weight:600\">%2</span>")
                       .arg(inkOf(kind_, t).name(), strong_.toHtmlEscaped());
    if (!text_.isEmpty()) {
        html += QStringLiteral("<span style=\"color:%1\"> \u2014 %2</span>")
                    .arg(t.text.name(), text_.toHtmlEscaped());
    }
    if (label_->text() != html) label_->setText(html);
}

void Banner::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) recolour();
    QWidget::changeEvent(event);
}

void Banner::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Tokens& t = tokensOf(palette());
    painter.fillRect(rect(), fillOf(kind_, t));
    painter.fillRect(QRect(0, height() - 1, width(), 1), t.line);
}

}  // namespace kickstand::ui
