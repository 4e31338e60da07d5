#include "ui/thunderbots/kick_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <bit>
#include <chrono>

#include "core/engine/describe.h"
#include "core/thunderbots/wire/readings.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/high_voltage_box.h"
#include "ui/thunderbots/kick_fields.h"
#include "ui/thunderbots/kick_preset_box.h"
#include "ui/thunderbots/kick_pulses_view.h"
#include "ui/thunderbots/kick_rows.h"
#include "ui/thunderbots/kick_state.h"
#include "ui/thunderbots/kick_words.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

using namespace std::chrono_literals;

constexpr int kVoltageWidth = 236;
constexpr int kColumnGap = 20;
constexpr int kLineGap = 4;
constexpr int kLineHeight = 18;
constexpr int kDropSize = 24;

constexpr std::array kWayNames{"kickFirst", "kickSecond", "kickBoth"};

QLabel* makeLine(const char* name, QWidget* parent) {
    auto* line = new QLabel(parent);
    line->setObjectName(QString::fromLatin1(name));
    line->setForegroundRole(QPalette::PlaceholderText);
    line->setMinimumHeight(kLineHeight);
    line->setWordWrap(true);
    return line;
}

QString clock(std::chrono::system_clock::time_point time) {
    return KickRows([time](TimePoint) { return time; }).clockText({});
}

}  // namespace

KickPanel::KickPanel(Bench& bench, RobotChoice& choice, KickSettings& kick, QWidget* parent)
    : Panel(bench, parent), choice_(choice), kick_(kick) {
    setObjectName(QStringLiteral("kickPanel"));
    kick_.attach(bench.settings());
    auto* left = new QVBoxLayout;
    left->setSpacing(kLineGap);
    left->addWidget(makePulses());
    left->addWidget(makeButtons());
    left->addWidget(makeAutokick());
    notice_ = makeLine("kickNotice", this);
    left->addWidget(notice_);
    left->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, 4);
    row->setSpacing(kColumnGap);
    row->addLayout(left, 1);
    row->addWidget(makeVoltage());
    connectAll();
    refresh();
}

QWidget* KickPanel::headerTools() {
    return new KickPresetBox(kick_, bench().settings(), this);
}

QWidget* KickPanel::makePulses() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kLineGap);
    view_ = new KickPulsesView(box);
    fields_ = new KickFields(box);
    wire_ = makeLine("kickWire", box);
    wire_->setFont(numberFont(metrics::kTextSize));
    column->addWidget(view_);
    column->addWidget(fields_);
    column->addWidget(wire_);
    return box;
}

QWidget* KickPanel::makeButtons() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    for (const KickWay way : kKickWays) {
        auto* one = new QPushButton(box);
        one->setObjectName(QString::fromLatin1(kWayNames.at(static_cast<std::size_t>(way))));
        one->setAutoDefault(false);
        auto* rename = new QAction(tr("Rename\u2026"), one);
        rename->setObjectName(one->objectName() + QStringLiteral("Rename"));
        rename->setShortcut(Qt::Key_F2);
        rename->setShortcutContext(Qt::WidgetShortcut);
        one->addAction(rename);
        one->setContextMenuPolicy(Qt::ActionsContextMenu);
        connect(rename, &QAction::triggered, this, [this, way] { this->rename(way); });
        connect(one, &QPushButton::clicked, this, [this, way] { kick(way); });
        ways_[static_cast<std::size_t>(way)] = one;
        row->addWidget(one);
    }
    setButtonRole(button(KickWay::First), ButtonRole::Primary);
    row->addStretch(1);
    return box;
}

/// What it has done stands beside its button: whoever sees one sees the other.
QWidget* KickPanel::makeAutokick() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    autokick_ = new QPushButton(box);
    autokick_->setObjectName(QStringLiteral("autokick"));
    autokick_->setCheckable(true);
    autokick_->setAutoDefault(false);
    autokickLine_ = makeLine("autokickLine", box);
    autokickLine_->setFont(textFont(metrics::kSmallTextSize));
    row->addWidget(autokick_);
    row->addWidget(autokickLine_, 1);
    return box;
}

QWidget* KickPanel::makeVoltage() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);
    voltage_ = new HighVoltageBox(QStringLiteral("kick"), box);
    voltage_->setFixedWidth(kVoltageWidth);
    charge_ = makeLine("chargeState", box);
    column->addWidget(voltage_);
    column->addWidget(charge_);
    drop_ = new QLabel(box);
    drop_->setObjectName(QStringLiteral("kickDrop"));
    drop_->setFont(numberFont(kDropSize, QFont::Bold));
    dropWhat_ = makeLine("kickDropWhat", box);
    column->addWidget(drop_);
    column->addWidget(dropWhat_);
    column->addStretch(1);
    return box;
}

void KickPanel::connectAll() {
    connect(view_, &KickPulsesView::asked, this, [this](const wire::KickPulses& pulses) {
        snapped_.clear();
        kick_.setPulses(pulses);
    });
    connect(fields_, &KickFields::snapped, this, [this](const QString& words) { snapped_ = words; });
    connect(fields_, &KickFields::asked, this, [this](const wire::KickPulses& pulses) {
        kick_.setPulses(pulses);
        refresh();
    });
    connect(autokick_, &QPushButton::clicked, this, &KickPanel::armAutokick);
    connect(voltage_, &HighVoltageBox::armAsked, this, [this](bool on) {
        ask(ArmHighVoltage{summary_.live, on});
    });
    connect(voltage_, &HighVoltageBox::chargerAsked, this, [this](bool on) {
        ask(SetCharger{summary_.live, on});
    });
    connect(voltage_, &HighVoltageBox::dischargeAsked, this, [this](bool on) {
        for (int robot = 0; robot < kRobots; ++robot) {
            if (contains(summary_.live, robot)) ask(Discharge{robot, on});
        }
    });
    connect(&kick_, &KickSettings::changed, this, &KickPanel::refresh);
    connect(&kick_, &KickSettings::labelsChanged, this, &KickPanel::refresh);
    connect(&choice_, &RobotChoice::changed, this, [this] {
        refusal_.clear();
        refresh();
    });
    connect(&bench(), &Bench::changed, this, &KickPanel::refresh);
    connect(&bench().client(), &EngineClient::stopChanged, this, &KickPanel::refresh);
    connect(&ages_, &QTimer::timeout, this, &KickPanel::refresh);
    ages_.start(1s);
}

void KickPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    static const Snapshot nothing;
    const Snapshot& shown = snapshot == nullptr ? nothing : *snapshot;
    summary_ = summarize(shown, choice_.chosen());
    const QString reason = reasonNotToUse(snapshot, summary_, bench().client().isStopped());
    showPulses();
    showButtons(snapshot);
    showVoltage(shown, reason);
    showLines(shown, reason);
    QString note = summary_.chosen == 0 ? tr("no robot chosen") : robotsText(summary_.chosen);
    if (summary_.capacitor_V) note += QStringLiteral(" \u00b7 ") + capacitorText(*summary_.capacitor_V);
    setNote(note);
}

void KickPanel::showPulses() {
    const wire::KickPulses& pulses = kick_.pulses();
    const auto encoded = wire::encodePulses(pulses);
    view_->showPulses(pulses);
    view_->setLabels(kick_.label(KickWay::First), kick_.label(KickWay::Second));
    fields_->showPulses(pulses);
    // Either button alone sends other times, which its tooltip has.
    const bool both = pulses.width1_us > 0 && pulses.width2_us > 0;
    QString text = !encoded ? tr("no such kick exists on the wire")
                   : both   ? tr("both on the wire: %1").arg(wireText(encoded->times))
                            : tr("on the wire: %1").arg(wireText(encoded->times));
    if (pulses.offset_us != 0 && (pulses.width1_us == 0 || pulses.width2_us == 0))
        text += tr("   offset unused");
    if (!snapped_.isEmpty()) text = QStringLiteral("%1   %2").arg(text, snapped_);
    wire_->setText(text);
    wire_->setToolTip(snapped_.isEmpty() ? text : QStringLiteral("%1\n%2").arg(text, snapped_));
}

void KickPanel::showButtons(const Snapshot* snapshot) {
    const bool stopped = bench().client().isStopped();
    const wire::KickPulses& pulses = kick_.pulses();
    for (const KickWay way : kKickWays) {
        const QString reason = reasonNotToKick(snapshot, summary_, stopped, pulses, way);
        QPushButton* one = button(way);
        one->setText(kick_.label(way));
        one->setEnabled(reason.isEmpty());
        const auto encoded = wire::encodePulses(pulsesFor(way, pulses));
        one->setToolTip(!reason.isEmpty() ? reason
                        : encoded         ? tr("Gives the dongle one kick of %1: %2. F2 renames the button.")
                                        .arg(pulsesText(encoded->sent), wireText(encoded->times))
                                  : QString());
    }
    const All armed = snapshot == nullptr ? All::None : autokicking(*snapshot, summary_.live);
    const QString reason = reasonNotToAutokick(snapshot, summary_, stopped, pulses);
    autokick_->setText(armed == All::None    ? tr("Arm autokick")
                       : armed == All::Every ? tr("Autokick armed")
                                             : tr("Autokick (some)"));
    if (waiting_ == 0) autokick_->setChecked(armed != All::None);
    // Disarming is always possible.
    autokick_->setEnabled(reason.isEmpty() || armed != All::None);
    autokick_->setToolTip(
        !reason.isEmpty() ? reason : tr("Kicks with what is drawn whenever the ball is in the beam."));
}

void KickPanel::showVoltage(const Snapshot& snapshot, const QString& reason) {
    voltage_->showState(summary_, bench().client().now(), waiting_ == 0);
    voltage_->setObstacle(reason);
    QString text;
    if (const int robot = onlyRobot(summary_); robot >= 0) {
        const auto at = static_cast<std::size_t>(robot);
        const RobotState& state = snapshot.robots[at];
        if (state.freshness == Freshness::Current)
            text =
                chargeText(snapshot.charges[at], state.readings, snapshot.intents[at].charger, snapshot.time);
    }
    charge_->setText(text);
    charge_->setVisible(!text.isEmpty());
    showDrop(snapshot);
}

void KickPanel::showDrop(const Snapshot& snapshot) {
    const KickRecord* last = lastKick(snapshot);
    const std::optional<double> drop_V = last == nullptr ? std::nullopt : last->drop_V();
    drop_->setVisible(drop_V.has_value());
    dropWhat_->setVisible(drop_V.has_value());
    if (!drop_V) return;
    drop_->setText(tr("\u2212%1").arg(capacitorText(*drop_V)));
    drop_->setToolTip(measureText(*last));
    QString what = last->cause == KickCause::Autokick ? tr("by the last autokick") : tr("by the last kick");
    if (last->times) what += QStringLiteral(", ") + pulsesText(wire::personTermsOf(*last->times));
    dropWhat_->setText(what);
}

QString KickPanel::autokickText(const Snapshot& snapshot) const {
    // Whoever has chosen none asks about all.
    const RobotMask asked = summary_.chosen == 0 ? kAllRobots : summary_.chosen;
    std::uint32_t count = 0;
    TimePoint last{};
    int lastRobot = -1;
    for (int robot = 0; robot < kRobots; ++robot) {
        const RobotState& state = snapshot.robots[static_cast<std::size_t>(robot)];
        if (!contains(asked, robot) || state.autokicks == 0) continue;
        count += state.autokicks;
        if (lastRobot >= 0 && state.lastAutokickAt < last) continue;
        last = state.lastAutokickAt;
        lastRobot = robot;
    }
    QString text = tr("none yet");
    if (count > 0) {
        const EngineClient& client = bench().client();
        text = tr("%1 fired, the last at %2, %3 ago")
                   .arg(count)
                   .arg(clock(client.wallTime(last)), ageText(client.now() - last));
        if (std::popcount(asked) > 1) text += tr(", by robot %1").arg(lastRobot);
    }
    const int robot = onlyRobot(summary_);
    if (robot < 0) return text;
    const RobotIntent& intent = snapshot.intents[static_cast<std::size_t>(robot)];
    const auto drawn = wire::encodePulses(kick_.pulses());
    if (intent.autokick && (!drawn || drawn->times != intent.autokickTimes)) {
        text += tr("\narmed with %1, not with what is drawn")
                    .arg(pulsesText(wire::personTermsOf(intent.autokickTimes)));
    }
    return text;
}

const KickRecord* KickPanel::lastKick(const Snapshot& snapshot) const {
    const auto chosen = [this](const KickRecord& record) { return contains(summary_.chosen, record.robot); };
    const auto last = std::find_if(snapshot.kicks->rbegin(), snapshot.kicks->rend(), chosen);
    return last == snapshot.kicks->rend() ? nullptr : &*last;
}

QString KickPanel::lastKickText(const Snapshot& snapshot) const {
    const KickRecord* last = lastKick(snapshot);
    if (last == nullptr) return tr("no kick yet");
    const QString what = last->cause == KickCause::Autokick ? tr("last autokick") : tr("last kick");
    return QStringLiteral("%1: %2").arg(what, measureText(*last));
}

void KickPanel::showLines(const Snapshot& snapshot, const QString& reason) {
    autokickLine_->setText(autokickText(snapshot));
    QString text = reason;
    if (text.isEmpty()) text = refusal_;
    if (text.isEmpty()) text = reasonImpossible(kick_.pulses());
    const bool trouble = !text.isEmpty();
    if (!trouble) {
        const QString blocked = reasonNotToAutokick(&snapshot, summary_, false, kick_.pulses());
        text = blocked.isEmpty() || autokicking(snapshot, summary_.live) != All::None
                   ? lastKickText(snapshot)
                   : QStringLiteral("%1 \u00b7 %2").arg(blocked, lastKickText(snapshot));
    }
    notice_->setText(text);
    notice_->setToolTip(text);
    notice_->setForegroundRole(trouble && reason.isEmpty() ? QPalette::WindowText
                                                           : QPalette::PlaceholderText);
}

void KickPanel::kick(KickWay way) {
    const int robot = onlyRobot(summary_);
    const auto encoded = wire::encodePulses(pulsesFor(way, kick_.pulses()));
    if (robot < 0 || !encoded) return;
    ask(Kick{robot, encoded->times});
}

void KickPanel::armAutokick(bool armed) {
    const auto encoded = wire::encodePulses(kick_.pulses());
    if (armed && !encoded) return;
    ask(SetAutokick{summary_.live, armed, armed ? encoded->times : wire::KickTimes{}});
}

void KickPanel::rename(KickWay way) {
    QInputDialog* dialog = askLine(this, tr("Rename button"), tr("What the button says"), kick_.label(way));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, way](const QString& label) { kick_.setLabel(way, label); });
    dialog->open();
}

void KickPanel::ask(const thunderbots::Command& command) {
    ++waiting_;
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        --waiting_;
        if (!result) refusal_ = describe(result.error()).line();
        refresh();
    });
}

void KickPanel::closed() {
    if (bench().isActive()) bench().client().stop(StopReason::PanelClosed);
}

}  // namespace kickstand::ui
