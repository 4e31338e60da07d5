#include "ui/coach/coach_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/engine/describe_coach.h"
#include "core/telemetry/store.h"
#include "ui/coach/charts.h"
#include "ui/coach/coach_view.h"
#include "ui/coach/conversation_view.h"
#include "ui/coach/helm_gamepad.h"
#include "ui/coach/helm_pad.h"
#include "ui/coach/morale_view.h"
#include "ui/shell/bench.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace coach;

namespace {

/// What the morale's history shows: a minute, in pieces of half a second.
constexpr std::size_t kHistoryPieces = 120;
constexpr Duration kHistoryPiece = std::chrono::milliseconds(500);
constexpr const char* kSeriesSetting = "coach/series";
constexpr int kMostTeams = 255;
QLabel* label(const char* name, int size, QWidget* parent) {
    auto* made = new QLabel(parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setFont(textFont(size));
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    return made;
}

/// Whether no Update Morale has come for so long that the boat stands by its own timer, if it heard nothing.
bool isSilent(const Snapshot& snapshot) {
    return std::ranges::any_of(snapshot.coach.timers, [&snapshot](const RunningTimer& timer) {
        const TimePoint lastHeard = timer.due - timer.span;
        return timer.kind == TimerKind::Silence && snapshot.time - lastHeard > kVelocitySpan;
    });
}

QVBoxLayout* column() {
    auto* made = new QVBoxLayout;
    made->setSpacing(metrics::kGap);
    return made;
}

}  // namespace

CoachPanel::CoachPanel(Bench& bench, MakePadSource makePads, QWidget* parent) : Panel(bench, parent) {
    empty_ = label("coachEmpty", metrics::kTextSize, this);
    body_ = new QWidget(this);
    auto* grid = new QGridLayout(body_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(metrics::kPadding);
    grid->addLayout(buildBoats(), 0, 0);
    grid->addLayout(buildHelm(std::move(makePads)), 0, 1);
    grid->addLayout(buildCrew(), 0, 2);
    chart_ = new ChartView(body_);
    chart_->setObjectName(QStringLiteral("coachChart"));
    grid->addWidget(chart_, 1, 0, 1, 3);
    // Shares of all three: with the length of its text the helm would grow and shrink.
    grid->setColumnStretch(0, 3);
    grid->setColumnStretch(1, 2);
    grid->setColumnStretch(2, 3);
    grid->setRowStretch(0, 1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    all->addWidget(empty_);
    all->addWidget(body_);
    connect(&bench, &Bench::changed, this, &CoachPanel::refresh);
    connect(&bench, &Bench::sessionChanged, this, &CoachPanel::recallSeries);
    recallSeries();
    refresh();
}

QPushButton* CoachPanel::button(const char* name, const QString& text, const coach::Command& command) {
    auto* made = new QPushButton(text, body_);
    made->setObjectName(QString::fromLatin1(name));
    connect(made, &QPushButton::clicked, this, [this, command] { submit(command); });
    return made;
}

QVBoxLayout* CoachPanel::buildBoats() {
    team_ = new QSpinBox(body_);
    team_->setObjectName(QStringLiteral("coachTeam"));
    team_->setRange(0, kMostTeams);
    team_->setPrefix(tr("COACH "));
    team_->setAccessibleName(tr("Team of this COACH"));
    color_ = new QComboBox(body_);
    color_->setObjectName(QStringLiteral("coachColor"));
    color_->setAccessibleName(tr("Team color"));
    color_->addItems({tr("Red team"), tr("Blue team")});
    start_ = new QPushButton(tr("Start up"), body_);
    start_->setObjectName(QStringLiteral("coachStart"));
    connect(start_, &QPushButton::clicked, this, [this] {
        submit(StartCoach{static_cast<Team>(team_->value()),
                          static_cast<wire::TeamColor>(color_->currentIndex())});
    });
    end_ = button("coachEnd", tr("End"), EndRole{});
    boats_ = new QTableWidget(0, 4, body_);
    boats_->setObjectName(QStringLiteral("coachBoats"));
    boats_->setAccessibleName(tr("Boats that are heard"));
    boats_->setHorizontalHeaderLabels({tr("TOWRP"), tr("Strength"), tr("Heard"), tr("State")});
    boats_->verticalHeader()->hide();
    boats_->horizontalHeader()->setStretchLastSection(true);
    boats_->setSelectionBehavior(QAbstractItemView::SelectRows);
    boats_->setSelectionMode(QAbstractItemView::SingleSelection);
    boats_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    boats_->setTabKeyNavigation(false);
    boats_->setMinimumHeight(96);
    pair_ = new QPushButton(tr("Pair"), body_);
    pair_->setObjectName(QStringLiteral("coachPair"));
    connect(pair_, &QPushButton::clicked, this, &CoachPanel::pairChosen);
    connect(boats_, &QTableWidget::itemSelectionChanged, this, &CoachPanel::offerPair);
    mayJettison_ = new QCheckBox(tr("Unlock"), body_);
    mayJettison_->setObjectName(QStringLiteral("coachMayJettison"));
    mayJettison_->setAccessibleName(tr("Unlock jettison"));
    jettison_ = button("coachJettison", tr("Jettison the crew"), Jettison{});
    connect(mayJettison_, &QCheckBox::toggled, this, &CoachPanel::refresh);
    auto* role = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{team_, color_, start_, end_})
        role->addWidget(widget);
    auto* choice = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{pair_, mayJettison_, jettison_})
        choice->addWidget(widget);
    QVBoxLayout* made = column();
    QLabel* ownTimer = label("coachOwnTimer", metrics::kSmallTextSize, body_);
    ownTimer->setText(
        tr("Lost line or closed window: the boat's own timer stops it, 1 s after its last velocity."));
    notice_ = label("coachNotice", metrics::kSmallTextSize, body_);
    notice_->hide();
    made->addLayout(role);
    made->addWidget(boats_, 1);
    made->addLayout(choice);
    made->addWidget(notice_);
    made->addWidget(ownTimer);
    return made;
}

QVBoxLayout* CoachPanel::buildHelm(MakePadSource makePads) {
    helm_ = new HelmPad(body_);
    helm_->setObjectName(QStringLiteral("coachHelm"));
    connect(helm_, &HelmPad::steered, this, [this](int forward, int turn) {
        const Snapshot* snapshot = coachOf(bench().session());
        if (snapshot != nullptr && snapshot->coach.state == CoachState::Paired)
            submit(Steer{{forward, turn}, true});
    });
    gamepad_ = new HelmGamepad(bench(), *helm_, std::move(makePads), this);
    padOn_ = new QPushButton(tr("Gamepad"), body_);
    padOn_->setObjectName(QStringLiteral("coachPad"));
    padOn_->setCheckable(true);
    padOn_->setToolTip(
        tr("Steers with the sticks for forward and turning. From then on its STOP button counts, "
           "whether it steers or not."));
    padState_ = label("coachPadState", metrics::kSmallTextSize, body_);
    connect(padOn_, &QPushButton::toggled, gamepad_, &HelmGamepad::setOn);
    connect(gamepad_, &HelmGamepad::changed, padState_,
            [this] { padState_->setText(gamepad_->stateText()); });
    told_ = label("coachTold", metrics::kSmallTextSize, body_);
    auto* below = new QVBoxLayout;
    below->setSpacing(4);
    for (QWidget* widget : std::initializer_list<QWidget*>{told_, padOn_, padState_})
        below->addWidget(widget);
    QVBoxLayout* made = column();
    made->addWidget(helm_, 1);
    made->addLayout(below);
    return made;
}

QVBoxLayout* CoachPanel::buildCrew() {
    morale_ = new MoraleView(body_);
    morale_->setObjectName(QStringLiteral("coachMorale"));
    mutiny_ = label("coachMutiny", metrics::kTextSize, body_);
    actions_ = new QWidget(body_);
    actionRow_ = new QHBoxLayout(actions_);
    actionRow_->setContentsMargins(0, 0, 0, 0);
    suppress_ = button("coachSuppress", tr("Suppress mutiny"), Suppress{});
    names_ = new QLineEdit(body_);
    names_->setObjectName(QStringLiteral("coachSeries"));
    names_->setAccessibleName(tr("Actions that quell a mutiny, in their order"));
    names_->setToolTip(tr("One to eight names with commas between them; Enter takes them"));
    connect(names_, &QLineEdit::returnPressed, this, &CoachPanel::nameSeries);
    digital_ = button("coachDigital", tr("Free digital"), FreeDigital{});
    percent_ = new QSpinBox(body_);
    percent_->setObjectName(QStringLiteral("coachPercent"));
    percent_->setRange(-100, 100);
    percent_->setSuffix(tr(" %"));
    percent_->setAccessibleName(tr("Free analog, in percent"));
    analog_ = new QPushButton(tr("Free analog"), body_);
    analog_->setObjectName(QStringLiteral("coachAnalog"));
    connect(analog_, &QPushButton::clicked, this, [this] { submit(FreeAnalog{percent_->value()}); });
    auto* crew = new QHBoxLayout;
    crew->addWidget(suppress_);
    crew->addWidget(names_, 1);
    auto* free = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{digital_, percent_, analog_})
        free->addWidget(widget);
    QVBoxLayout* made = column();
    made->addWidget(morale_);
    made->addWidget(mutiny_);
    made->addWidget(actions_);
    made->addLayout(crew);
    made->addLayout(free);
    conversation_ = new ConversationView(bench(), body_);
    conversation_->setObjectName(QStringLiteral("coachConversation"));
    made->addWidget(conversation_, 1);
    return made;
}

void CoachPanel::buildSeries(const std::vector<std::string>& actions) {
    if (actions == series_) return;
    series_ = actions;
    QStringList names;
    for (const std::string& action : actions)
        names << QString::fromStdString(action);
    names_->setText(names.join(QStringLiteral(", ")));
    for (QPushButton* old : actionButtons_)
        old->deleteLater();
    actionButtons_.clear();
    for (std::size_t i = 0; i < actions.size(); ++i) {
        auto* made = new QPushButton(QString::fromStdString(actions[i]), actions_);
        made->setObjectName(QStringLiteral("coachAction%1").arg(i));
        connect(made, &QPushButton::clicked, this, [this, i] { submit(Act{i}); });
        actionRow_->addWidget(made);
        actionButtons_.push_back(made);
    }
}

void CoachPanel::nameSeries() {
    setSeries(names_->text(), [this, names = names_->text()](const Result<void>& result) {
        showRefusal(result);
        if (result) bench().settings().setValue(kSeriesSetting, names);
    });
}

void CoachPanel::setSeries(const QString& names, const EngineClient::Answered& answered) {
    SetSeries series;
    for (const QString& name : names.split(QLatin1Char(','), Qt::SkipEmptyParts))
        series.actions.push_back(name.trimmed().toStdString());
    bench().submit(SystemCommand{coach::Command{series}}, this, answered);
}

/// A session knows nothing of the series that was named in the last one.
void CoachPanel::recallSeries() {
    const QString names = bench().settings().value(kSeriesSetting).toString();
    if (!names.isEmpty() && coachOf(bench().session()) != nullptr) setSeries(names, {});
}

void CoachPanel::showRefusal(const Result<void>& result) {
    notice_->setText(result ? QString() : describe(result.error()).line());
    notice_->setVisible(!result);
}

void CoachPanel::submit(const coach::Command& command) {
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) { showRefusal(result); });
}

void CoachPanel::closed() {
    padOn_->setChecked(false);
    helm_->letGo();
}

void CoachPanel::hideEvent(QHideEvent* event) {
    gamepad_->awaitNeutral();
    Panel::hideEvent(event);
}

std::optional<Team> CoachPanel::chosenBoat() const {
    const QList<QTableWidgetItem*> chosen = boats_->selectedItems();
    if (chosen.isEmpty()) return std::nullopt;
    return static_cast<Team>(chosen.front()->data(Qt::UserRole).toInt());
}

void CoachPanel::pairChosen() {
    if (const std::optional<Team> boat = chosenBoat()) submit(Pair{*boat});
}

void CoachPanel::offerPair() {
    const Snapshot* snapshot = coachOf(bench().session());
    pair_->setEnabled(snapshot != nullptr && snapshot->coach.state == CoachState::NotPaired && chosenBoat());
}

void CoachPanel::refresh() {
    const Snapshot* snapshot = coachOf(bench().session());
    const bool ready = snapshot != nullptr && snapshot->link == LinkState::Running;
    body_->setVisible(ready);
    empty_->setVisible(!ready);
    if (snapshot == nullptr) {
        empty_->setText(
            tr("No radio module of a COACH is connected. Connect a serial port with an XBee adapter, or "
               "simulated boats."));
        return;
    }
    if (snapshot->link == LinkState::Searching) {
        empty_->setText(tr("%1. A boat that was driven stops by its own timer, within a second of its last "
                           "velocity.")
                            .arg(describe(snapshot->link)));
        return;
    }
    if (!ready) {
        empty_->setText(
            tr("%1. The Radio panel looks for the module and sets it up.").arg(describe(snapshot->link)));
        return;
    }
    buildSeries(snapshot->series);
    showBoats(*snapshot);
    showHelm(*snapshot);
    showCrew(*snapshot);
    chart_->show(coachChart(*snapshot));
    conversation_->show(snapshot->entries);
    setNote(snapshot->role == wire::Role::Coach ? tr("COACH %1").arg(snapshot->coach.team) : QString());
}

void CoachPanel::showBoats(const Snapshot& snapshot) {
    const coach::CoachView& view = snapshot.coach;
    const bool off = !snapshot.role;
    const Team own = wire::teamOf(snapshot.radio ? snapshot.radio->settings.address : std::uint16_t{0});
    if (off && !team_->hasFocus()) team_->setValue(own);
    for (QWidget* widget : std::initializer_list<QWidget*>{team_, color_, start_})
        widget->setEnabled(off);
    end_->setEnabled(!off);
    fillBoats(snapshot);
    const bool paired = view.state == CoachState::Paired;
    offerPair();
    mayJettison_->setEnabled(paired);
    if (!paired) mayJettison_->setChecked(false);
    jettison_->setEnabled(paired && mayJettison_->isChecked());
}

QString CoachPanel::stateOf(const HeardBoat& boat, const Snapshot& snapshot) {
    if (snapshot.coach.state == CoachState::Paired) {
        return boat.team == snapshot.coach.boat ? tr("paired with this COACH")
                                                : tr("not listened to while paired");
    }
    if (snapshot.time - boat.heard > coach::kPairedSilence) return tr("not heard any more");
    return boat.coach ? tr("obeys COACH %1").arg(*boat.coach) : tr("available");
}

void CoachPanel::fillBoats(const Snapshot& snapshot) {
    const coach::CoachView& view = snapshot.coach;
    // A boat that is heard for the first time moves the others: the choice stays with its team.
    const std::optional<Team> chosen = chosenBoat();
    const QSignalBlocker quiet(boats_);
    boats_->setRowCount(static_cast<int>(view.boats.size()));
    for (int row = 0; row < boats_->rowCount(); ++row) {
        const HeardBoat& boat = view.boats[static_cast<std::size_t>(row)];
        const QStringList texts{QString::number(boat.team), tr("%1 dBm").arg(signedNumber(boat.rssi_dBm)),
                                tr("%1 s ago").arg(seconds(snapshot.time - boat.heard), 0, 'f', 0),
                                stateOf(boat, snapshot)};
        for (int place = 0; place < texts.size(); ++place) {
            QTableWidgetItem* item = boats_->item(row, place);
            if (item == nullptr) boats_->setItem(row, place, item = new QTableWidgetItem);
            if (item->text() != texts[place]) item->setText(texts[place]);
            item->setData(Qt::UserRole, int{boat.team});
        }
        if (chosen == boat.team) boats_->selectRow(row);
    }
}

void CoachPanel::showHelm(const Snapshot& snapshot) {
    const coach::CoachView& view = snapshot.coach;
    const bool paired = view.state == CoachState::Paired;
    if (!paired || bench().client().isStopped()) {
        helm_->letGo();
        gamepad_->awaitNeutral();
    }
    helm_->setEnabled(paired);
    const bool answered = view.answered == view.sent;
    helm_->setTold(paired ? view.sent : std::nullopt, answered);
    if (!paired) {
        told_->setText(tr("The helm works once a boat is paired."));
    } else if (view.sent) {
        told_->setText(
            tr("Told: %1, %2").arg(describe(*view.sent), answered ? tr("answered") : tr("not answered yet")));
    }
    for (QWidget* widget : std::initializer_list<QWidget*>{digital_, percent_, analog_})
        widget->setEnabled(paired);
}

std::vector<float> CoachPanel::moraleHistory(const Snapshot& snapshot) const {
    std::vector<float> history;
    const SessionSnapshot* session = bench().session();
    if (!snapshot.coach.boat || session->telemetry == nullptr) return history;
    const TimeSeries* series = session->telemetry->find(
        {std::uint16_t{*snapshot.coach.boat}, static_cast<std::uint16_t>(Signal::Morale)});
    std::vector<Column> columns(kHistoryPieces);
    const TimePoint start = snapshot.time - kHistoryPiece * static_cast<int>(kHistoryPieces);
    if (series == nullptr || !series->columns(start, kHistoryPiece, columns)) return history;
    history.reserve(columns.size());
    for (const Column& column : columns)
        history.push_back(column.last);
    return history;
}

void CoachPanel::showCrew(const Snapshot& snapshot) {
    const coach::CoachView& view = snapshot.coach;
    std::optional<double> left;
    if (view.mutiny) left = seconds(view.mutiny->until - snapshot.time) / seconds(kMutinySpan);
    morale_->show(view.morale, left, moraleHistory(snapshot));
    const bool paired = view.state == CoachState::Paired;
    suppress_->setEnabled(paired);
    for (std::size_t i = 0; i < actionButtons_.size(); ++i)
        actionButtons_[i]->setEnabled(view.mutiny.has_value() && !view.mutiny->suppressed);
    if (!view.mutiny) {
        const QString crew = view.morale == wire::kMutinyMorale ? tr("The crew has taken the boat.")
                             : isSilent(snapshot)               ? tr("The boat does not answer.")
                                                                : tr("The crew obeys.");
        mutiny_->setText(paired ? crew : QString());
        return;
    }
    const double left_s = seconds(view.mutiny->until - snapshot.time);
    mutiny_->setText(view.mutiny->suppressed ? tr("MUTINY: suppressing, %1 s left").arg(left_s, 0, 'f', 1)
                                             : tr("MUTINY: %1 s left, actions done: %2 of %3")
                                                   .arg(left_s, 0, 'f', 1)
                                                   .arg(view.mutiny->done)
                                                   .arg(snapshot.series.size()));
}

}  // namespace kickstand::ui
