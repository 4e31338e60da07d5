#include "ui/coach/towrp_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/engine/describe_coach.h"
#include "ui/coach/charts.h"
#include "ui/coach/coach_view.h"
#include "ui/coach/conversation_view.h"
#include "ui/shell/bench.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace coach;

namespace {

constexpr int kValueSize = 28;

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    for (QWidget* widget : widgets)
        row->addWidget(widget);
    row->addStretch(1);
    return row;
}

}  // namespace

TowrpPanel::TowrpPanel(Bench& bench, QWidget* parent)
    : Panel(bench, parent),
      empty_(new QLabel(this)),
      body_(new QWidget(this)),
      team_(new QSpinBox(body_)),
      start_(new QPushButton(tr("Wake"), body_)),
      end_(new QPushButton(tr("End"), body_)),
      notice_(new QLabel(body_)),
      velocity_(new QLabel(body_)),
      received_(new QLabel(body_)),
      morale_(new QLabel(body_)),
      wanted_(new QSpinBox(body_)),
      set_(new QPushButton(tr("Set morale"), body_)),
      mutiny_(new QPushButton(tr("Mutiny"), body_)),
      chart_(new ChartView(body_)),
      conversation_(new ConversationView(bench, body_)) {
    build();
    connect(start_, &QPushButton::clicked, this,
            [this] { submit(StartTowrp{static_cast<Team>(team_->value())}); });
    connect(end_, &QPushButton::clicked, this, [this] { submit(EndRole{}); });
    connect(set_, &QPushButton::clicked, this, [this] { submit(SetMorale{wanted_->value()}); });
    connect(mutiny_, &QPushButton::clicked, this, [this] { submit(SetMorale{wire::kMutinyMorale}); });
    connect(&bench, &Bench::changed, this, &TowrpPanel::refresh);
    refresh();
}

void TowrpPanel::build() {
    team_->setObjectName(QStringLiteral("towrpTeam"));
    team_->setRange(0, 255);
    team_->setPrefix(tr("TOWRP "));
    team_->setAccessibleName(tr("Team of this TOWRP"));
    start_->setObjectName(QStringLiteral("towrpStart"));
    end_->setObjectName(QStringLiteral("towrpEnd"));
    velocity_->setObjectName(QStringLiteral("towrpVelocity"));
    velocity_->setFont(numberFont(kValueSize, QFont::Bold));
    received_->setObjectName(QStringLiteral("towrpReceived"));
    received_->setWordWrap(true);
    morale_->setObjectName(QStringLiteral("towrpMorale"));
    morale_->setFont(numberFont(kValueSize, QFont::Bold));
    wanted_->setObjectName(QStringLiteral("towrpWanted"));
    wanted_->setRange(wire::kMutinyMorale, 127);
    wanted_->setAccessibleName(tr("The crew's morale"));
    set_->setObjectName(QStringLiteral("towrpSet"));
    mutiny_->setObjectName(QStringLiteral("towrpMutiny"));
    mutiny_->setToolTip(tr("Sets the morale to −10"));
    empty_->setObjectName(QStringLiteral("towrpEmpty"));
    empty_->setWordWrap(true);
    conversation_->setObjectName(QStringLiteral("towrpConversation"));
    auto* inner = new QVBoxLayout(body_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(metrics::kGap);
    notice_->setObjectName(QStringLiteral("towrpNotice"));
    notice_->setWordWrap(true);
    notice_->hide();
    inner->addLayout(rowOf({team_, start_, end_}));
    inner->addWidget(notice_);
    inner->addWidget(velocity_);
    inner->addWidget(received_);
    inner->addLayout(rowOf({morale_, wanted_, set_, mutiny_}));
    inner->addWidget(chart_);
    inner->addWidget(conversation_, 1);
    chart_->setObjectName(QStringLiteral("towrpChart"));
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    all->addWidget(empty_);
    all->addWidget(body_);
}

void TowrpPanel::submit(const coach::Command& command) {
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        notice_->setText(result ? QString() : describe(result.error()).line());
        notice_->setVisible(!result);
    });
}

void TowrpPanel::refresh() {
    const Snapshot* snapshot = coachOf(bench().session());
    const bool ready = snapshot != nullptr && snapshot->link == LinkState::Running;
    body_->setVisible(ready);
    empty_->setVisible(!ready);
    if (!ready) {
        empty_->setText(
            snapshot == nullptr
                ? tr("No radio module of a TOWRP is connected. Connect a serial port with an XBee "
                     "adapter, or be a simulated boat.")
                : tr("%1. The Radio panel looks for the module and sets it up.")
                      .arg(describe(snapshot->link)));
        return;
    }
    showBoat(*snapshot);
    conversation_->show(snapshot->entries);
}

void TowrpPanel::showBoat(const Snapshot& snapshot) {
    const TowrpView& view = snapshot.towrp;
    const bool off = !snapshot.role;
    if (off && !team_->hasFocus() && snapshot.radio)
        team_->setValue(wire::teamOf(snapshot.radio->settings.address));
    team_->setEnabled(off);
    start_->setEnabled(off);
    end_->setEnabled(!off);
    const bool paired = view.state == TowrpState::Paired;
    for (QWidget* widget : std::initializer_list<QWidget*>{wanted_, set_, mutiny_})
        widget->setEnabled(paired);
    velocity_->setText(view.coach ? describe(view.velocity) : tr("not paired"));
    QStringList words;
    if (view.coach) words << tr("obeys COACH %1").arg(*view.coach);
    if (view.stoppedItself) words << tr("stopped by itself: no velocity for a second");
    if (view.freeDigital > 0) words << tr("free digital, times: %1").arg(view.freeDigital);
    if (view.freeAnalog) words << tr("free analog: %1 %").arg(*view.freeAnalog);
    if (view.counters.foreign > 0) words << tr("foreign packets: %1").arg(view.counters.foreign);
    received_->setText(words.join(QStringLiteral(" · ")));
    morale_->setText(tr("Morale %1").arg(signedNumber(view.morale)));
    chart_->show(towrpChart(snapshot));
    setNote(off ? QString() : tr("TOWRP %1").arg(view.team));
}

}  // namespace kickstand::ui
