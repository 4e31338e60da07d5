#include "ui/motionplan/motionplan_view.h"

#include <QCoreApplication>
#include <map>

#include "core/engine/describe.h"
#include "core/engine/describe_motionplan.h"
#include "ui/motionplan/plan_document.h"
#include "ui/motionplan/plan_panel.h"
#include "ui/motionplan/plan_robot_panel.h"

namespace kickstand::ui {

using motionplan::LinkState;
using motionplan::Snapshot;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MotionplanView)
};

constexpr const char* kHelpPage = "motion-plans.md";

QString help(const char* anchor) {
    return QLatin1String(kHelpPage) + u'#' + QLatin1String(anchor);
}

Tone toneOf(LinkState state) {
    switch (state) {
        case LinkState::Running:
            return Tone::Good;
        case LinkState::Failed:
            return Tone::Danger;
        case LinkState::Searching:
            return Tone::Warning;
        default:
            return Tone::Busy;
    }
}

}  // namespace

const Snapshot* planSnapshotOf(const SessionSnapshot* session) {
    return session == nullptr ? nullptr : std::get_if<Snapshot>(&session->system);
}

MotionplanView::MotionplanView() : document_(std::make_unique<PlanDocument>()) {}

MotionplanView::~MotionplanView() = default;

QString MotionplanView::name() const {
    return Words::tr("Motion plans");
}

std::vector<PanelEntry> MotionplanView::panels() const {
    PlanDocument& document = *document_;
    return {
        {QStringLiteral("plan-robot"), Words::tr("NXT"), help("the-robot"), PanelPlace::Side,
         [&document](Bench& bench) -> Panel* { return new PlanRobotPanel(bench, document); }},
        {QStringLiteral("plan"), Words::tr("Plan"), help("the-plan-editor"), PanelPlace::Work,
         [&document](Bench& bench) -> Panel* { return new PlanPanel(bench, document); }},
    };
}

std::vector<LinkOffer> MotionplanView::offers() const {
    LinkUri uri;
    uri.scheme = "sim";
    uri.target = "motionplan";
    return {{Words::tr("A simulated NXT"), Words::tr("Start with a simulated NXT"),
             Words::tr("A virtual robot that takes motion plans and executes them."), uri}};
}

bool MotionplanView::owns(const SystemSnapshot& system) const {
    return std::holds_alternative<Snapshot>(system);
}

bool MotionplanView::isMoving(const SystemSnapshot& system) const {
    return std::get<Snapshot>(system).active();
}

bool MotionplanView::isActive(const SystemSnapshot& system) const {
    return std::get<Snapshot>(system).active();
}

std::vector<StateText> MotionplanView::states(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    const QString device = session.uri.isSimulated() ? Words::tr("Simulated NXT") : Words::tr("NXT");
    std::vector<StateText> states{
        {toneOf(snapshot.link), Words::tr("%1 \u00b7 %2").arg(device, describe(snapshot.link)), {}}};
    if (snapshot.outOfReach) {
        states.push_back({Tone::Danger, Words::tr("STOP cannot reach the robot"), {}});
    } else if (snapshot.link == LinkState::Running) {
        const Tone tone = snapshot.active() ? Tone::Busy : (snapshot.answers ? Tone::Good : Tone::Warning);
        states.push_back(
            {tone, snapshot.answers ? describe(snapshot.execution.state) : Words::tr("no answer"), {}});
    }
    return states;
}

const Error* MotionplanView::obstacle(const SystemSnapshot& system) const {
    const auto& snapshot = std::get<Snapshot>(system);
    if (snapshot.link == LinkState::Running || !snapshot.error) return nullptr;
    return &*snapshot.error;
}

QStringList MotionplanView::facts(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    QStringList facts;
    if (snapshot.link == LinkState::Running)
        facts << Words::tr("%1 telegrams out, %2 in")
                     .arg(snapshot.traffic.telegramsOut)
                     .arg(snapshot.traffic.telegramsIn);
    if (snapshot.traffic.resends > 0) facts << Words::tr("%1 sent again").arg(snapshot.traffic.resends);
    if (snapshot.traffic.timeouts > 0) facts << Words::tr("%1 unanswered").arg(snapshot.traffic.timeouts);
    const std::uint64_t damaged = snapshot.traffic.malformed + snapshot.traffic.skipped;
    if (damaged > 0) facts << Words::tr("%1 damaged").arg(damaged);
    return facts;
}

std::vector<Hazard> MotionplanView::hazards(const SystemSnapshot& system) const {
    const auto& snapshot = std::get<Snapshot>(system);
    std::vector<Hazard> hazards;
    if (snapshot.outOfReach) hazards.push_back({outOfReachText(), snapshot.time, true, true});
    if (snapshot.link != LinkState::Running) return hazards;
    if (snapshot.trigger.plan != motionplan::wire::kNoPlan)
        hazards.push_back({(snapshot.trigger.known
                                ? Words::tr("the robot starts its trigger plan %1 when the connection ends")
                                : Words::tr("the robot may start trigger plan %1 when the connection ends"))
                               .arg(snapshot.trigger.plan),
                           snapshot.trigger.at, false, true});
    else if (!snapshot.trigger.known)
        hazards.push_back({Words::tr("whether the robot has a trigger plan, which starts when the connection "
                                     "ends, is not known"),
                           snapshot.time, false, true});
    return hazards;
}

QString MotionplanView::simulatedText(const LinkUri&) const {
    return Words::tr("a virtual NXT");
}

std::vector<int> MotionplanView::chosenUnits() const {
    return {};
}

QString MotionplanView::actionText(const SimAction& action) const {
    static const std::map<std::string, const char*> texts = {
        {"plugged", QT_TRANSLATE_NOOP("MotionplanView", "Bluetooth")},
        {"loss", QT_TRANSLATE_NOOP("MotionplanView", "Lost messages")},
        {"reply-loss", QT_TRANSLATE_NOOP("MotionplanView", "Unanswered reads")},
        {"duplicate", QT_TRANSLATE_NOOP("MotionplanView", "Doubled messages")},
        {"delay", QT_TRANSLATE_NOOP("MotionplanView", "Delay of messages")},
        {"lose-next", QT_TRANSLATE_NOOP("MotionplanView", "Lose the next to the robot")},
        {"lose-next-out", QT_TRANSLATE_NOOP("MotionplanView", "Lose the next from the robot")},
        {"lose-one-out", QT_TRANSLATE_NOOP("MotionplanView", "Lose one of the next from the robot")},
        {"text", QT_TRANSLATE_NOOP("MotionplanView", "Mailbox read as")},
        {"program", QT_TRANSLATE_NOOP("MotionplanView", "Program")},
        {"pace", QT_TRANSLATE_NOOP("MotionplanView", "Pace")},
        {"strict-update", QT_TRANSLATE_NOOP("MotionplanView", "Updates at rest")},
        {"error", QT_TRANSLATE_NOOP("MotionplanView", "Error message")},
    };
    const auto found = texts.find(action.name);
    return found == texts.end() ? QString::fromStdString(action.name) : Words::tr(found->second);
}

std::vector<std::pair<QString, double>> MotionplanView::actionChoices(const SimAction& action) const {
    if (action.name == "plugged") return {{Words::tr("In reach"), 1}, {Words::tr("Gone"), 0}};
    if (action.name == "text") return {{Words::tr("Bytes"), 0}, {Words::tr("Text"), 1}};
    if (action.name == "program") return {{Words::tr("Runs"), 1}, {Words::tr("Ended"), 0}};
    if (action.name == "strict-update") return {{Words::tr("Taken"), 0}, {Words::tr("Refused"), 1}};
    return {};
}

QString MotionplanView::unitText(int unit) const {
    return Words::tr("NXT %1").arg(unit);
}

}  // namespace kickstand::ui
