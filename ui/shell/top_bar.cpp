#include "ui/shell/top_bar.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QPushButton>

#include "ui/shell/bench.h"
#include "ui/shell/stop_button.h"
#include "ui/shell/system_view.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kHeight = 48;
constexpr int kStateGap = 20;

QPushButton* menuButton(const QString& text, QMenu* menu, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setMenu(menu);
    button->setAutoDefault(false);
    return button;
}

}  // namespace

TopBar::TopBar(Bench& bench, QMenu* connectMenu, QMenu* viewMenu, QMenu* helpMenu, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      connect_(menuButton(tr("&Connect"), connectMenu, this)),
      stop_(new StopButton(this)),
      states_(new QHBoxLayout) {
    setFixedHeight(kHeight);
    connect_->setObjectName(QStringLiteral("connect"));
    connect_->setAccessibleName(tr("Connect"));
    QPushButton* view = menuButton(tr("&View"), viewMenu, this);
    QPushButton* help = menuButton(tr("&Help"), helpMenu, this);
    setButtonRole(view, ButtonRole::Flat);
    setButtonRole(help, ButtonRole::Flat);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, 0, metrics::kPadding, 1);
    row->setSpacing(metrics::kPadding);
    states_->setSpacing(kStateGap);
    row->addWidget(connect_);
    row->addLayout(states_);
    row->addStretch(1);
    row->addWidget(view);
    row->addWidget(help);
    row->addWidget(stop_);

    QObject::connect(&bench_, &Bench::changed, this, &TopBar::refresh);
    QObject::connect(&bench_.client(), &EngineClient::stopChanged, this,
                     [this] { stop_->setStopped(bench_.client().isStopped()); });
    QObject::connect(stop_, &QPushButton::pressed, this,
                     [this] { bench_.client().stop(StopReason::Person); });
    stop_->setStopped(bench_.client().isStopped());
    refresh();
}

void TopBar::refresh() {
    std::vector<StateText> states;
    if (const SystemView* view = bench_.view()) {
        states = view->states(*bench_.session());
    } else if (bench_.isConnecting()) {
        states.push_back({Tone::Busy, tr("Connecting\u2026"), {}});
    } else {
        states.push_back({Tone::Idle, tr("Not connected"), {}});
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
        stateLabel(i)->setState(states[i].tone, states[i].text, states[i].strong);
    }
    for (std::size_t i = 0; i < labels_.size(); ++i)
        labels_[i]->setVisible(i < states.size());
}

StateLabel* TopBar::stateLabel(std::size_t index) {
    while (labels_.size() <= index) {
        auto* label = new StateLabel(this);
        label->setObjectName(QStringLiteral("state%1").arg(labels_.size()));
        states_->addWidget(label);
        labels_.push_back(label);
    }
    return labels_[index];
}

void TopBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Tokens& t = tokensOf(palette());
    painter.fillRect(rect(), t.surface);
    painter.fillRect(QRect(0, height() - 1, width(), 1), t.line);
}

}  // namespace kickstand::ui
