#include "ui/coach/coach_view.h"

#include <QCoreApplication>
#include <map>

#include "core/engine/describe_coach.h"
#include "ui/coach/coach_panel.h"
#include "ui/coach/radio_panel.h"
#include "ui/coach/towrp_panel.h"
#include "ui/gamepad/sdl_pads.h"

namespace kickstand::ui {

using namespace coach;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(CoachView)
};

QString help(const char* anchor) {
    return QStringLiteral("coach-guide.md#") + QLatin1String(anchor);
}

LinkUri simulation(std::map<std::string, std::string> options) {
    LinkUri uri;
    uri.scheme = "sim";
    uri.target = "coach";
    uri.options = std::move(options);
    return uri;
}

}  // namespace

const Snapshot* coachOf(const SessionSnapshot* session) {
    return session == nullptr ? nullptr : std::get_if<Snapshot>(&session->system);
}

CoachView::CoachView(MakePadSource makePads) : makePads_(std::move(makePads)) {
    if (!makePads_) makePads_ = [] { return std::make_unique<SdlPads>(); };
}

QString CoachView::name() const {
    return Words::tr("COACH and TOWRP");
}

std::vector<PanelEntry> CoachView::panels() const {
    return {{QStringLiteral("coach"), Words::tr("COACH"), help("steer-a-boat"), PanelPlace::Work,
             [this](Bench& bench) -> Panel* { return new CoachPanel(bench, makePads_); }},
            {QStringLiteral("towrp"), Words::tr("TOWRP"), help("be-the-boat"), PanelPlace::Work,
             [](Bench& bench) -> Panel* { return new TowrpPanel(bench); }},
            {QStringLiteral("radio"), Words::tr("Radio"), help("set-up-a-radio-module"), PanelPlace::Work,
             [](Bench& bench) -> Panel* { return new RadioPanel(bench); }}};
}

std::vector<LinkOffer> CoachView::offers() const {
    return {{Words::tr("Simulated COACH radio, three boats"), Words::tr("Start with simulated boats"),
             Words::tr("The XBee adapter of COACH 5, and boats of teams 3, 5 and 7."), simulation({})},
            {Words::tr("Simulated TOWRP radio, a COACH"), Words::tr("Be a simulated boat"),
             Words::tr("The XBee adapter of TOWRP 5, and a COACH that drives it."),
             simulation({{"address", "0xAF05"}, {"coaches", "4"}, {"towrps", ""}})}};
}

bool CoachView::owns(const SystemSnapshot& system) const {
    return std::holds_alternative<Snapshot>(system);
}

bool CoachView::isMoving(const SystemSnapshot& system) const {
    return std::get<Snapshot>(system).active();
}

bool CoachView::isActive(const SystemSnapshot& system) const {
    return std::get<Snapshot>(system).active();
}

std::vector<StateText> CoachView::states(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    const QString device = session.uri.isSimulated() ? Words::tr("Simulated XBee") : Words::tr("XBee");
    Tone tone = Tone::Busy;
    if (snapshot.link == LinkState::Running) tone = Tone::Good;
    if (snapshot.link == LinkState::NoModule || snapshot.link == LinkState::Searching) tone = Tone::Warning;
    if (snapshot.link == LinkState::Failed) tone = Tone::Danger;
    std::vector<StateText> states{{tone, Words::tr("%1 \u00b7 %2").arg(device, describe(snapshot.link)), {}}};
    if (snapshot.role == wire::Role::Coach)
        states.push_back({snapshot.coach.state == CoachState::Paired ? Tone::Good : Tone::Idle,
                          Words::tr("COACH %1").arg(snapshot.coach.team), describe(snapshot.coach.state)});
    if (snapshot.role == wire::Role::Towrp)
        states.push_back({snapshot.towrp.state == TowrpState::NotPaired ? Tone::Idle : Tone::Good,
                          Words::tr("TOWRP %1").arg(snapshot.towrp.team), describe(snapshot.towrp.state)});
    return states;
}

const Error* CoachView::obstacle(const SystemSnapshot& system) const {
    const auto& snapshot = std::get<Snapshot>(system);
    if (snapshot.link == LinkState::Running || !snapshot.error) return nullptr;
    return &*snapshot.error;
}

QStringList CoachView::facts(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    QStringList facts{Words::tr("%1 frames").arg(snapshot.traffic.frames.frames)};
    if (snapshot.traffic.failed > 0) facts << Words::tr("%1 not acknowledged").arg(snapshot.traffic.failed);
    if (snapshot.traffic.frames.damaged() > 0)
        facts << Words::tr("%1 damaged").arg(snapshot.traffic.frames.damaged());
    if (const auto foreign = snapshot.coach.counters.foreign + snapshot.towrp.counters.foreign; foreign > 0)
        facts << Words::tr("%1 foreign").arg(foreign);
    return facts;
}

std::vector<Hazard> CoachView::hazards(const SystemSnapshot&) const {
    return {};
}

QString CoachView::simulatedText(const LinkUri& uri) const {
    const auto address = uri.options.find("address");
    return address == uri.options.end()
               ? Words::tr("virtual boats")
               : Words::tr("virtual radios, here %1").arg(QString::fromStdString(address->second));
}

std::vector<int> CoachView::chosenUnits() const {
    return {};
}

QString CoachView::actionText(const SimAction& action) const {
    static const std::map<std::string, const char*> texts = {
        {"morale", QT_TRANSLATE_NOOP("CoachView", "Morale")},
        {"dead", QT_TRANSLATE_NOOP("CoachView", "Power")},
        {"loss", QT_TRANSLATE_NOOP("CoachView", "Radio loss")},
        {"boat-loss", QT_TRANSLATE_NOOP("CoachView", "Radio loss of a boat")},
        {"plugged", QT_TRANSLATE_NOOP("CoachView", "USB plug")},
        {"restart", QT_TRANSLATE_NOOP("CoachView", "Radio module")}};
    const auto found = texts.find(action.name);
    return found == texts.end() ? QString::fromStdString(action.name) : Words::tr(found->second);
}

std::vector<std::pair<QString, double>> CoachView::actionChoices(const SimAction& action) const {
    if (action.name == "dead") return {{Words::tr("Off"), 1}, {Words::tr("On"), 0}};
    if (action.name == "plugged") return {{Words::tr("In"), 1}, {Words::tr("Out"), 0}};
    if (action.name == "restart") return {{Words::tr("Restart"), 1}};
    return {};
}

QString CoachView::unitText(int unit) const {
    return Words::tr("TOWRP %1").arg(unit);
}

}  // namespace kickstand::ui
