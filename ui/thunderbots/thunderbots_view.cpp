#include "ui/thunderbots/thunderbots_view.h"

#include <QCoreApplication>
#include <map>

#include "core/engine/describe.h"
#include "core/thunderbots/wire/readings.h"
#include "ui/gamepad/sdl_pads.h"
#include "ui/thunderbots/checks_panel.h"
#include "ui/thunderbots/drive_control.h"
#include "ui/thunderbots/drive_pad.h"
#include "ui/thunderbots/drive_pad_panel.h"
#include "ui/thunderbots/drive_panel.h"
#include "ui/thunderbots/experiment_panel.h"
#include "ui/thunderbots/faults_panel.h"
#include "ui/thunderbots/flash_panel.h"
#include "ui/thunderbots/kick_log_panel.h"
#include "ui/thunderbots/kick_panel.h"
#include "ui/thunderbots/leds_panel.h"
#include "ui/thunderbots/parameters_panel.h"
#include "ui/thunderbots/robots_panel.h"
#include "ui/thunderbots/voltages_panel.h"
#include "ui/thunderbots/wheel_unit.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ThunderbotsView)
};

constexpr const char* kHelpPage = "bench-guide.md";
/// All of the Drive and of the Kick panel.
constexpr int kWorkHeight = 392;

/// The guide's page at one of its headings.
QString help(const char* anchor) {
    return QLatin1String(kHelpPage) + u'#' + QLatin1String(anchor);
}

LinkUri simulation(std::map<std::string, std::string> options) {
    LinkUri uri;
    uri.scheme = "sim";
    uri.target = "thunderbots";
    uri.options = std::move(options);
    return uri;
}

StateText linkState(const SessionSnapshot& session, const Snapshot& snapshot) {
    const bool simulated = session.uri.isSimulated();
    const QString device = snapshot.cable
                               ? (simulated ? Words::tr("Simulated cable") : Words::tr("Robot cable"))
                               : (simulated ? Words::tr("Simulated dongle") : Words::tr("Dongle"));
    const auto with = [&device](const QString& state) {
        return Words::tr("%1 \u00b7 %2").arg(device, state);
    };
    switch (snapshot.link) {
        case LinkState::Running:
            return {
                Tone::Good, with(snapshot.cable ? describe(snapshot.link) : Words::tr("radios running")), {}};
        case LinkState::Failed:
            return {Tone::Danger, with(describe(snapshot.link)), {}};
        case LinkState::Searching:
            return {Tone::Warning, with(describe(snapshot.link)), {}};
        default:
            return {Tone::Busy, with(describe(snapshot.link)), {}};
    }
}

StateText emergencyStopState(wire::EStop state) {
    const Tone tone = state == wire::EStop::Run             ? Tone::Good
                      : state == wire::EStop::Uninitialized ? Tone::Idle
                                                            : Tone::Warning;
    return {tone, Words::tr("E-stop"), describe(state).toUpper()};
}

}  // namespace

const Snapshot* snapshotOf(const SessionSnapshot* session) {
    return session == nullptr ? nullptr : std::get_if<Snapshot>(&session->system);
}

ThunderbotsView::ThunderbotsView(Ledger& ledger)
    : ledger_(ledger), drive_(std::make_unique<DriveControl>(*choice_)) {}

ThunderbotsView::~ThunderbotsView() = default;

QString ThunderbotsView::name() const {
    return Words::tr("Thunderbots");
}

std::vector<PanelEntry> ThunderbotsView::panels() const {
    RobotChoice& choice = *choice_;
    KickSettings& kick = *kick_;
    DriveControl& drive = *drive_;
    Ledger& ledger = ledger_;
    return {
        {QStringLiteral("robots"), Words::tr("Robots"), help("robots"), PanelPlace::Side,
         [&choice](Bench& bench) -> Panel* { return new RobotsPanel(bench, choice); }},
        {QStringLiteral("drive"), Words::tr("Drive"), help("drive"), PanelPlace::Work,
         [&drive](Bench& bench) -> Panel* { return new DrivePanel(bench, drive); }},
        {QStringLiteral("kick"), Words::tr("Kick"), help("kick"), PanelPlace::Work,
         [&choice, &kick](Bench& bench) -> Panel* { return new KickPanel(bench, choice, kick); }},
        {QStringLiteral("voltages"), Words::tr("Voltages"), help("voltages"), PanelPlace::Below,
         [&choice](Bench& bench) -> Panel* { return new VoltagesPanel(bench, choice); }},
        {QStringLiteral("kicks"), Words::tr("Kicks"), help("kick"), PanelPlace::Below,
         [&choice, &kick](Bench& bench) -> Panel* { return new KickLogPanel(bench, choice, kick); }},
        {QStringLiteral("checks"), Words::tr("Checks"), help("checks"), PanelPlace::Work,
         [&choice](Bench& bench) -> Panel* { return new ChecksPanel(bench, choice); }},
        {QStringLiteral("parameters"), Words::tr("Parameters"), help("parameters"), PanelPlace::Work,
         [&choice, &ledger](Bench& bench) -> Panel* { return new ParametersPanel(bench, choice, ledger); }},
        {QStringLiteral("firmware"), Words::tr("Firmware"), help("firmware"), PanelPlace::Work,
         [&choice](Bench& bench) -> Panel* { return new FlashPanel(bench, choice); }},
        {QStringLiteral("leds"), Words::tr("Test LEDs"), help("test-leds"), PanelPlace::Aside,
         [&choice](Bench& bench) -> Panel* { return new LedsPanel(bench, choice); }},
        {QStringLiteral("experiment"), Words::tr("Experiment data"), help("experiment-data"),
         PanelPlace::Work, [&choice](Bench& bench) -> Panel* { return new ExperimentPanel(bench, choice); }},
        {QStringLiteral("gamepad"), Words::tr("Gamepad"), help("gamepad"), PanelPlace::Work,
         [&drive, &kick](Bench& bench) -> Panel* {
             auto* pad = new DrivePad(bench, drive, kick, [] { return std::make_unique<SdlPads>(); });
             return new DrivePadPanel(bench, drive, pad);
         }},
        {QStringLiteral("faults"), Words::tr("Fault codes"), help("fault-codes"), PanelPlace::Work,
         [](Bench& bench) -> Panel* { return new FaultsPanel(bench); }},
    };
}

std::vector<UnitChoice> ThunderbotsView::unitChoices() const {
    return {{kWheelSpeed, Words::tr("&Wheel speeds"), wheelUnitTexts()}};
}

std::vector<LinkOffer> ThunderbotsView::offers() const {
    return {
        {Words::tr("Sixteen simulated robots"), Words::tr("Start with sixteen simulated robots"),
         Words::tr("A virtual dongle and its robots: nothing to plug in, nothing to break."), simulation({})},
        {Words::tr("Sixteen robots, 5 % radio loss, simulated"),
         Words::tr("Sixteen simulated, 5 % radio loss"),
         Words::tr("The same sixteen, heard through a bad radio."), simulation({{"loss", "0.05"}})},
        {Words::tr("One simulated robot on a cable"), Words::tr("One simulated robot on a cable"),
         Words::tr("One virtual robot, connected without a radio."), simulation({{"cable", "3"}})},
    };
}

bool ThunderbotsView::owns(const SystemSnapshot& system) const {
    return std::holds_alternative<Snapshot>(system);
}

bool ThunderbotsView::isMoving(const SystemSnapshot& system) const {
    for (const RobotIntent& intent : std::get<Snapshot>(system).intents) {
        if (intent.run || intent.dribbler || intent.charger || intent.autokick || intent.discharging ||
            intent.sweeping)
            return true;
    }
    return false;
}

bool ThunderbotsView::isActive(const SystemSnapshot& system) const {
    return std::get<Snapshot>(system).active();
}

std::vector<StateText> ThunderbotsView::states(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    std::vector<StateText> states{linkState(session, snapshot)};
    if (!snapshot.cable && snapshot.link == LinkState::Running)
        states.push_back(emergencyStopState(snapshot.eStop));
    return states;
}

QString ThunderbotsView::rearmHindrance(const SystemSnapshot& system) const {
    const auto& snapshot = std::get<Snapshot>(system);
    const bool pressed =
        !snapshot.cable && snapshot.link == LinkState::Running && snapshot.eStop != wire::EStop::Run;
    return pressed ? Words::tr("Turn the emergency stop back to run first.") : QString();
}

const Error* ThunderbotsView::obstacle(const SystemSnapshot& system) const {
    const auto& snapshot = std::get<Snapshot>(system);
    if (snapshot.link == LinkState::Running || !snapshot.error) return nullptr;
    return &*snapshot.error;
}

QStringList ThunderbotsView::facts(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    QStringList facts;
    if (snapshot.link == LinkState::Running)
        facts << Words::tr("%1 packets/s").arg(snapshot.traffic.packets_per_s, 0, 'f', 0);
    // Unplugged, nobody knows what they are.
    if (snapshot.channels && snapshot.link == LinkState::Running) {
        facts
            << Words::tr("radios %1 / %2").arg(snapshot.channels->channel0).arg(snapshot.channels->channel1);
    }
    if (snapshot.roundTrip)
        facts << Words::tr("server %1 ms away").arg(seconds(*snapshot.roundTrip) * 1000, 0, 'f', 1);
    if (snapshot.traffic.malformed > 0) facts << Words::tr("%1 damaged").arg(snapshot.traffic.malformed);
    if (snapshot.traffic.stalls > 0) facts << Words::tr("%1 stalls").arg(snapshot.traffic.stalls);
    return facts;
}

std::vector<Hazard> ThunderbotsView::hazards(const SystemSnapshot& system) const {
    const auto& snapshot = std::get<Snapshot>(system);
    std::vector<Hazard> hazards;
    for (int robot = 0; robot < kRobots; ++robot) {
        const RobotState& state = snapshot.robots[static_cast<std::size_t>(robot)];
        if (!isLive(state)) continue;
        Hazard hazard;
        hazard.text =
            Words::tr("robot %1: %2 on its capacitor").arg(robot).arg(capacitorText(state.capacitor->last_V));
        hazard.at = state.capacitor->at;
        hazard.stale = state.freshness != Freshness::Current;
        hazards.push_back(std::move(hazard));
    }
    return hazards;
}

QString ThunderbotsView::simulatedText(const LinkUri& uri) const {
    if (const auto cable = uri.options.find("cable"); cable != uri.options.end()) {
        return Words::tr("virtual robot %1 on a cable").arg(QString::fromStdString(cable->second));
    }
    const auto robots = uri.options.find("robots");
    QString text = robots == uri.options.end() || robots->second == "0-15"
                       ? Words::tr("sixteen virtual robots")
                       : Words::tr("virtual robots %1").arg(QString::fromStdString(robots->second));
    if (const auto loss = uri.options.find("loss"); loss != uri.options.end()) {
        text += Words::tr("; radio loss %1 %")
                    .arg(QString::fromStdString(loss->second).toDouble() * 100, 0, 'g', 3);
    }
    return text;
}

std::vector<int> ThunderbotsView::chosenUnits() const {
    std::vector<int> units;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (choice_->isChosen(robot)) units.push_back(robot);
    }
    return units;
}

QString ThunderbotsView::actionText(const SimAction& action) const {
    static const std::map<std::string, const char*> texts = {
        {"ball", QT_TRANSLATE_NOOP("ThunderbotsView", "Ball")},
        {"battery", QT_TRANSLATE_NOOP("ThunderbotsView", "Battery")},
        {"capacitor", QT_TRANSLATE_NOOP("ThunderbotsView", "Capacitor")},
        {"dead-wheels", QT_TRANSLATE_NOOP("ThunderbotsView", "Dead wheels")},
        {"broken-charger", QT_TRANSLATE_NOOP("ThunderbotsView", "Charger")},
        {"dead", QT_TRANSLATE_NOOP("ThunderbotsView", "Power")},
        {"e-stop", QT_TRANSLATE_NOOP("ThunderbotsView", "Emergency stop")},
        {"radio-failure", QT_TRANSLATE_NOOP("ThunderbotsView", "Radio failure")},
        {"loss", QT_TRANSLATE_NOOP("ThunderbotsView", "Radio loss")},
        {"duplicate", QT_TRANSLATE_NOOP("ThunderbotsView", "Duplicated packets")},
        {"delay", QT_TRANSLATE_NOOP("ThunderbotsView", "Radio delay")},
        {"plugged", QT_TRANSLATE_NOOP("ThunderbotsView", "USB plug")},
        {"stall", QT_TRANSLATE_NOOP("ThunderbotsView", "Stalled endpoint")},
        {"experiment", QT_TRANSLATE_NOOP("ThunderbotsView", "Experiment")},
        {"temperature", QT_TRANSLATE_NOOP("ThunderbotsView", "Temperature")},
        {"error", QT_TRANSLATE_NOOP("ThunderbotsView", "Dongle error code")},
    };
    const auto found = texts.find(action.name);
    return found == texts.end() ? QString::fromStdString(action.name) : Words::tr(found->second);
}

std::vector<std::pair<QString, double>> ThunderbotsView::actionChoices(const SimAction& action) const {
    const auto switches = [](const QString& on, const QString& off) {
        return std::vector<std::pair<QString, double>>{{on, 1}, {off, 0}};
    };
    if (action.name == "ball") return switches(Words::tr("In"), Words::tr("Out"));
    if (action.name == "dead-wheels") {
        return {{Words::tr("None"), 0}, {Words::tr("1"), 1}, {Words::tr("2"), 2},
                {Words::tr("3"), 4},    {Words::tr("4"), 8}, {Words::tr("All"), 15}};
    }
    if (action.name == "broken-charger") return switches(Words::tr("Broken"), Words::tr("Works"));
    if (action.name == "dead") return switches(Words::tr("Off"), Words::tr("On"));
    if (action.name == "plugged") return switches(Words::tr("In"), Words::tr("Out"));
    if (action.name == "experiment") return {{Words::tr("Send"), 1}};
    if (action.name == "e-stop") {
        return {{Words::tr("Run"), 3}, {Words::tr("Stop"), 2}, {Words::tr("Unplugged"), 1}};
    }
    if (action.name == "radio-failure") {
        return {{Words::tr("None"), -1}, {Words::tr("Radio 0"), 0}, {Words::tr("Radio 1"), 1}};
    }
    if (action.name == "stall") {
        return {{Words::tr("0x05 drive"), 0x05},        {Words::tr("0x85 feedback"), 0x85},
                {Words::tr("0x06 messages out"), 0x06}, {Words::tr("0x86 messages in"), 0x86},
                {Words::tr("0x81 status"), 0x81},       {Words::tr("0x82 errors"), 0x82},
                {Words::tr("0x84 debug text"), 0x84}};
    }
    return {};
}

int ThunderbotsView::workHeight() const {
    return kWorkHeight;
}

QString ThunderbotsView::unitText(int unit) const {
    return Words::tr("Robot %1").arg(unit);
}

QString ThunderbotsView::placeOf(const SystemEvent& event) const {
    const auto* own = std::get_if<Event>(&event);
    if (own == nullptr || own->kind != EventKind::DongleFault || own->code < 0 || own->code > UINT8_MAX)
        return {};
    return FaultsPanel::placeOf(static_cast<std::uint8_t>(own->code));
}

}  // namespace kickstand::ui
