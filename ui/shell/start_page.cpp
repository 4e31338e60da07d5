#include "ui/shell/start_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/engine/describe.h"
#include "core/engine/describe_facts.h"
#include "ui/shell/bench.h"
#include "ui/shell/connector.h"
#include "ui/shell/port_offers.h"
#include "ui/shell/system_view.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kColumnWidth = 560;
constexpr int kHeadlineSize = 28;
constexpr int kLeadSize = 15;
constexpr int kBigButtonHeight = 44;

QLabel* wrapped(const QString& text, QWidget* parent, int size = metrics::kTextSize) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setFont(textFont(size));
    return label;
}

void clear(QVBoxLayout* layout) {
    while (QLayoutItem* item = layout->takeAt(0)) {
        if (item->widget() != nullptr) item->widget()->deleteLater();
        delete item;
    }
}

}  // namespace

StartPage::StartPage(Bench& bench, Connector& connector, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      connector_(connector),
      headline_(wrapped({}, this, kHeadlineSize)),
      advice_(wrapped({}, this, kLeadSize)),
      found_(new QVBoxLayout) {
    setObjectName(QStringLiteral("startPage"));
    headline_->setFont(textFont(kHeadlineSize, QFont::DemiBold));
    advice_->setForegroundRole(QPalette::PlaceholderText);
    auto* centre = new QWidget(this);
    centre->setFixedWidth(kColumnWidth);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kPadding);
    found_->setSpacing(metrics::kGap);
    column->addWidget(headline_);
    column->addWidget(advice_);
    column->addLayout(found_);
    column->addSpacing(metrics::kPadding);
    addOffers(column);
    auto* doctor = new QPushButton(tr("Why does it not work?"), this);
    doctor->setObjectName(QStringLiteral("startDoctor"));
    doctor->setAutoDefault(false);
    doctor->setToolTip(tr("Looks at everything between this program and a robot, and says what to do."));
    connect(doctor, &QPushButton::clicked, this, &StartPage::doctorAsked);
    column->addWidget(doctor, 0, Qt::AlignLeft);
    auto* page = new QVBoxLayout(this);
    page->addStretch(2);
    page->addWidget(centre, 0, Qt::AlignHCenter);
    page->addStretch(3);
    connect(&bench_, &Bench::changed, this, &StartPage::refresh);
    refresh();
}

void StartPage::addOffers(QVBoxLayout* column) {
    bool first = true;
    for (const auto& view : bench_.systems().views()) {
        QHBoxLayout* row = nullptr;
        for (const LinkOffer& offer : view->offers()) {
            auto* button = new QPushButton(offer.invitation, this);
            button->setAutoDefault(false);
            button->setToolTip(offer.explanation);
            connect(button, &QPushButton::clicked, this,
                    [this, uri = offer.uri] { connector_.connectTo(uri); });
            if (first) {
                button->setObjectName(QStringLiteral("simulate"));
                setButtonRole(button, ButtonRole::Primary);
                button->setFont(textFont(kLeadSize, QFont::DemiBold));
                button->setFixedHeight(kBigButtonHeight);
                column->addWidget(button);
                auto* explanation = new QLabel(offer.explanation, this);
                explanation->setForegroundRole(QPalette::PlaceholderText);
                column->addWidget(explanation);
                first = false;
                continue;
            }
            if (row == nullptr) {
                row = new QHBoxLayout;
                row->setSpacing(metrics::kGap);
                column->addLayout(row);
            }
            row->addWidget(button);
        }
        if (row != nullptr) row->addStretch(1);
    }
    auto* other = new QPushButton(tr("Enter link\u2026"), this);
    other->setObjectName(QStringLiteral("startEnterLink"));
    other->setAutoDefault(false);
    connect(other, &QPushButton::clicked, &connector_, &Connector::askForLink);
    column->addWidget(other, 0, Qt::AlignLeft);
}

void StartPage::addPort(const BytePort& port) {
    auto* button = new QPushButton(tr("Connect to %1 as").arg(titleOf(port)), this);
    button->setObjectName(QStringLiteral("startPort"));
    button->setAutoDefault(false);
    button->setToolTip(tr("A serial port does not say what is at its other end: choose it."));
    auto* menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    ui::addOffers(*menu, port, bench_.systems(), connector_);
    button->setMenu(menu);
    found_->addWidget(button);
}

void StartPage::refresh() {
    if (bench_.session() != nullptr) return;
    const EngineSnapshot& snapshot = bench_.client().snapshot();
    const bool any = !snapshot.found.empty();
    headline_->setText(any ? tr("A robot link is plugged in") : tr("No robot is connected"));
    if (any) {
        advice_->setText(tr("Connecting brakes all robots first. Nothing moves until you drive it."));
    } else if (snapshot.discovered) {
        advice_->setText(tr("Plug in the dongle, or a robot's own cable: it shows up here by itself."));
    } else {
        advice_->setText(tr("Looking for a dongle or a robot's cable\u2026"));
    }
    QStringList now;
    for (const FoundDevice& found : snapshot.found) {
        now << Connector::titleOf(found) + (found.obstacle ? describe(*found.obstacle).line() : QString());
    }
    for (const BytePort& port : snapshot.ports)
        now << titleOf(port) + printable(port.name);
    if (now == shown_) return;
    shown_ = now;
    clear(found_);
    for (const FoundDevice& found : snapshot.found) {
        auto* button = new QPushButton(tr("Connect to %1").arg(Connector::titleOf(found)), this);
        button->setAutoDefault(false);
        button->setFixedHeight(kBigButtonHeight);
        button->setEnabled(!found.obstacle.has_value());
        connect(button, &QPushButton::clicked, this, [this, uri = found.uri] { connector_.connectTo(uri); });
        found_->addWidget(button);
        if (found.obstacle) found_->addWidget(wrapped(describe(*found.obstacle).line(), this));
    }
    for (const BytePort& port : snapshot.ports)
        addPort(port);
}

void StartPage::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    painter.setPen(QPen(t.line, 1));
    painter.setBrush(t.surface);
    const int gap = metrics::kGap;
    painter.drawRoundedRect(QRectF(rect()).adjusted(gap + 0.5, gap + 0.5, -gap - 0.5, -gap - 0.5),
                            metrics::kPanelRadius, metrics::kPanelRadius);
}

}  // namespace kickstand::ui
