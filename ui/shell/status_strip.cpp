#include "ui/shell/status_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/shell/bench.h"
#include "ui/shell/system_view.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kHeight = 26;
constexpr int kButtonHeight = 22;
constexpr int kFontSize = 12;

QLabel* quietLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setFont(numberFont(kFontSize));
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

}  // namespace

StatusStrip::StatusStrip(Bench& bench, QWidget* parent)
    : QWidget(parent), bench_(bench), link_(quietLabel(this)), facts_(quietLabel(this)) {
    setFixedHeight(kHeight);
    link_->setObjectName(QStringLiteral("link"));
    facts_->setObjectName(QStringLiteral("facts"));
    link_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QLabel* keys = quietLabel(this);
    keys->setText(tr("F1 help \u00b7 Space STOP"));
    auto* doctor = new QPushButton(tr("Why does it not work?"), this);
    doctor->setObjectName(QStringLiteral("doctorButton"));
    doctor->setFont(textFont(kFontSize));
    doctor->setAutoDefault(false);
    doctor->setFixedHeight(kButtonHeight);
    setButtonRole(doctor, ButtonRole::Flat);
    connect(doctor, &QPushButton::clicked, this, &StatusStrip::doctorAsked);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, 1, metrics::kPadding, 0);
    row->setSpacing(18);
    row->addWidget(link_);
    row->addWidget(facts_, 1);
    row->addWidget(doctor);
    row->addWidget(keys);
    connect(&bench_, &Bench::changed, this, &StatusStrip::refresh);
    refresh();
}

void StatusStrip::refresh() {
    const SessionSnapshot* session = bench_.session();
    const SystemView* view = bench_.view();
    link_->setText(session == nullptr ? tr("no link") : QString::fromStdString(toString(session->uri)));
    const QString facts = view == nullptr ? QString() : view->facts(*session).join(QStringLiteral("     "));
    if (facts_->text() != facts) facts_->setText(facts);
}

void StatusStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Tokens& t = tokensOf(palette());
    painter.fillRect(rect(), t.surface);
    painter.fillRect(QRect(0, 0, width(), 1), t.line);
}

}  // namespace kickstand::ui
