#include "ui/thunderbots/leds_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <chrono>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/leds_lights.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;
using wire::TestClass;
using wire::TestMode;

namespace {

enum WaySegment { kMessage = 0, kBlock = 1 };
/// More than these are not told one by one.
constexpr std::size_t kMostGroups = 3;

QLabel* paragraph(const char* name, int size, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setFont(textFont(size));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

/// The robots of a choice, by what their LEDs show.
std::vector<std::pair<LedState, RobotMask>> groupsOf(const Snapshot& snapshot, RobotMask robots) {
    std::vector<std::pair<LedState, RobotMask>> groups;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        const LedState state = ledStateOf(snapshot.robots[static_cast<std::size_t>(robot)]);
        auto same = std::find_if(groups.begin(), groups.end(), [&state](const auto& group) {
            return group.first.message == state.message && group.first.block == state.block;
        });
        if (same == groups.end()) same = groups.insert(groups.end(), {state, RobotMask{0}});
        same->second |= maskOf(robot);
    }
    return groups;
}

TestMode shownBy(const LedState& state) {
    return state.showsBlock() ? state.block : state.message.value_or(TestMode{});
}

}  // namespace

LedsPanel::LedsPanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      class_(new QComboBox(this)),
      target_(new QComboBox(this)),
      way_(new Segmented({tr("Message"), tr("Drive block")}, this)),
      lights_(new LedLights(this)),
      advice_(paragraph("ledAdvice", metrics::kSmallTextSize, this)),
      normal_(new QPushButton(tr("Normal lights"), this)),
      told_(paragraph("ledTold", metrics::kSmallTextSize, this)),
      notice_(paragraph("ledNotice", metrics::kTextSize, this)) {
    build();
    connectControls();
    fillTargets();
    followChoice();
}

void LedsPanel::build() {
    class_->setObjectName(QStringLiteral("ledClass"));
    class_->setAccessibleName(tr("What the LEDs show"));
    for (const TestClass testClass : ledClasses())
        class_->addItem(ledClassText(testClass), static_cast<int>(testClass));
    target_->setObjectName(QStringLiteral("ledTarget"));
    target_->setAccessibleName(tr("Of which wheel or motor"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, 4);
    column->setSpacing(metrics::kGap);
    auto* mode = new QVBoxLayout;
    mode->setSpacing(4);
    mode->addWidget(class_);
    mode->addWidget(target_);
    column->addLayout(mode);
    column->addWidget(lights_);
    column->addWidget(notice_);
    column->addWidget(makeWays());
    column->addWidget(told_);
    // Known after the first time: where there is too little room, this is what has to be scrolled to.
    column->addWidget(advice_);
    column->addStretch(1);
}

QWidget* LedsPanel::makeWays() {
    way_->button(kMessage)->setObjectName(QStringLiteral("ledByMessage"));
    way_->button(kMessage)->setToolTip(
        tr("Sent once, as a message: shown until another message or a reboot, also after STOP."));
    way_->button(kBlock)->setObjectName(QStringLiteral("ledInBlock"));
    way_->button(kBlock)->setToolTip(tr(
        "Part of every drive block: shown while that is sent, in place of the message's; ends with STOP."));
    way_->setCurrent(kMessage);
    normal_->setObjectName(QStringLiteral("ledNormal"));
    normal_->setAutoDefault(false);
    normal_->setToolTip(tr("Ends every test mode of the chosen robots, whichever way it was asked for."));
    auto* ways = new QWidget(this);
    auto* row = new QVBoxLayout(ways);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(way_);
    row->addWidget(normal_);
    return ways;
}

void LedsPanel::connectControls() {
    connect(class_, &QComboBox::activated, this, [this] {
        fillTargets();
        ask();
    });
    connect(target_, &QComboBox::activated, this, &LedsPanel::ask);
    connect(way_, &Segmented::asked, this, [this](int index) {
        chosenWay_ = index == kBlock ? TestModeWay::DriveBlock : TestModeWay::Message;
        way_->setCurrent(index);
        ask();
    });
    connect(normal_, &QPushButton::clicked, this, &LedsPanel::askNormal);
    connect(&choice_, &RobotChoice::changed, this, &LedsPanel::followChoice);
    connect(&bench(), &Bench::changed, this, &LedsPanel::refresh);
    connect(&bench().client(), &EngineClient::stopChanged, this, &LedsPanel::refresh);
    // "For 12 s" goes on while nothing else happens.
    connect(&ages_, &QTimer::timeout, this, &LedsPanel::refresh);
    ages_.start(std::chrono::seconds(1));
}

void LedsPanel::fillTargets() {
    const auto testClass = static_cast<TestClass>(class_->currentData().toInt());
    const wire::TestTargets targets = wire::targetsOf(testClass);
    const int before = target_->currentData().toInt();
    target_->clear();
    for (int target = targets.first; targets.any() && target <= targets.last; ++target)
        target_->addItem(ledTargetText(testClass, target), target);
    // The same wheel goes on being looked at.
    target_->setCurrentIndex(std::max(0, target_->findData(before)));
    target_->setVisible(targets.any());
}

TestMode LedsPanel::wanted() const {
    return {static_cast<TestClass>(class_->currentData().toInt()),
            static_cast<std::uint8_t>(target_->currentData().toInt())};
}

void LedsPanel::ask() {
    submit(live_, wanted(), chosenWay_);
}

void LedsPanel::askNormal() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    class_->setCurrentIndex(0);
    fillTargets();
    if (snapshot == nullptr) return;
    RobotMask inBlock = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        const auto& mode = snapshot->intents[static_cast<std::size_t>(robot)].driveTestMode;
        if (contains(live_, robot) && mode.testClass != TestClass::None) inBlock |= maskOf(robot);
    }
    if (inBlock != 0) submit(inBlock, {}, TestModeWay::DriveBlock);
    submit(live_, {}, TestModeWay::Message);
}

void LedsPanel::submit(RobotMask robots, const TestMode& mode, TestModeWay way) {
    refusal_.clear();
    if (robots == 0) return;
    bench().submit(SystemCommand{thunderbots::Command{SetTestMode{robots, mode, way}}}, this,
                   [this](const Result<void>& result) { answered(result); });
}

void LedsPanel::answered(const Result<void>& result) {
    refusal_ = result ? QString() : describe(result.error()).line();
    refresh();
}

void LedsPanel::followChoice() {
    refusal_.clear();
    const Snapshot* snapshot = snapshotOf(bench().session());
    for (int robot = 0; snapshot != nullptr && robot < kRobots; ++robot) {
        if (!choice_.isChosen(robot)) continue;
        const LedState state = ledStateOf(snapshot->robots[static_cast<std::size_t>(robot)]);
        const TestMode mode = shownBy(state);
        class_->setCurrentIndex(std::max(0, class_->findData(static_cast<int>(mode.testClass))));
        fillTargets();
        target_->setCurrentIndex(std::max(0, target_->findData(mode.target)));
        break;
    }
    refresh();
}

QString LedsPanel::reasonNotTo(const Snapshot* snapshot) const {
    if (snapshot == nullptr) return tr("Not connected.");
    if (snapshot->link != LinkState::Running)
        return tr("The link does not run: %1.").arg(describe(snapshot->link));
    if (choice_.chosen() == 0) return tr("Choose a robot: click its tile.");
    if (live_ == 0)
        return tr("%1 is not heard. Switch it on, or choose another.").arg(robotsText(choice_.chosen()));
    return {};
}

void LedsPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    live_ = 0;
    for (int robot = 0; snapshot != nullptr && robot < kRobots; ++robot) {
        if (choice_.isChosen(robot) && snapshot->robots[static_cast<std::size_t>(robot)].live)
            live_ |= maskOf(robot);
    }
    const QString reason = reasonNotTo(snapshot);
    for (QWidget* control : std::initializer_list<QWidget*>{class_, target_, way_, normal_})
        control->setEnabled(reason.isEmpty());
    setNote(choice_.chosen() == 0 ? tr("no robot chosen") : robotsText(choice_.chosen()));
    static const Snapshot nothing;
    showTold(snapshot == nullptr ? nothing : *snapshot);
    const bool onlyBrakes = bench().client().isStopped() && chosenWay_ == TestModeWay::DriveBlock;
    const QString stopped =
        onlyBrakes ? tr("Stopped: drive blocks only brake. Re-arm, or send a message.") : QString();
    const QString notice = !reason.isEmpty() ? reason : !refusal_.isEmpty() ? refusal_ : stopped;
    notice_->setText(notice);
    notice_->setVisible(!notice.isEmpty());
    notice_->setForegroundRole(reason.isEmpty() ? QPalette::WindowText : QPalette::PlaceholderText);
}

void LedsPanel::showTold(const Snapshot& snapshot) {
    const auto groups = groupsOf(snapshot, live_);
    const TestMode shown = groups.size() == 1 ? shownBy(groups.front().first) : wanted();
    lights_->setMode(shown);
    advice_->setText(ledAdvice(shown));
    QStringList lines;
    for (const auto& [state, robots] : groups) {
        if (lines.size() == kMostGroups) {
            lines << tr("\u2026 and others show something else.");
            break;
        }
        const QString who = groups.size() == 1 ? QString() : tr("%1\n").arg(robotsText(robots));
        lines << who + stateText(state);
    }
    told_->setText(lines.join(u'\n'));
    told_->setVisible(!lines.isEmpty());
}

QString LedsPanel::stateText(const LedState& state) const {
    const auto line = [this](bool shown, const QString& way, const QString& what) {
        return (shown ? tr("\u25cf %1, shown now: %2") : tr("\u25cb %1: %2")).arg(way, what);
    };
    const QString message =
        state.message ? tr("%1, for %2").arg(ledModeText(*state.message), sinceText(state.messageSince))
                      : tr("none on this connection");
    const QString block = state.showsBlock()
                              ? tr("%1, for %2").arg(ledModeText(state.block), sinceText(state.blockSince))
                              : tr("nothing");
    return line(!state.showsBlock() && state.message.has_value(), tr("By message"), message) + u'\n' +
           line(state.showsBlock(), tr("In the drive block"), block);
}

QString LedsPanel::sinceText(TimePoint since) const {
    return ageText(bench().client().now() - since);
}

}  // namespace kickstand::ui
