#include "ui/smartdevice/smartdevice_view.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>

#include "ui/smartdevice/cards_panel.h"
#include "ui/smartdevice/device_card.h"
#include "ui/smartdevice/device_choice.h"
#include "ui/smartdevice/device_panel.h"
#include "ui/smartdevice/devices_panel.h"
#include "ui/smartdevice/plots_panel.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SmartdeviceView)
};

QString help(const char* anchor) {
    return QStringLiteral("smart-devices.md#") + QLatin1String(anchor);
}

int countOf(const Snapshot& snapshot, Presence presence) {
    return static_cast<int>(std::ranges::count(snapshot.devices, presence, &DeviceState::presence));
}

}  // namespace

const Snapshot* boardsOf(const SessionSnapshot* session) {
    return session == nullptr ? nullptr : std::get_if<Snapshot>(&session->system);
}

SmartdeviceView::SmartdeviceView() : choice_(std::make_unique<DeviceChoice>()) {}

SmartdeviceView::~SmartdeviceView() = default;

QString SmartdeviceView::name() const {
    return Words::tr("Smart devices");
}

std::vector<PanelEntry> SmartdeviceView::panels() const {
    DeviceChoice& choice = *choice_;
    return {
        {QStringLiteral("boards-list"), Words::tr("Devices"), help("devices"), PanelPlace::Side,
         [&choice](Bench& bench) -> Panel* { return new DevicesPanel(bench, choice); }},
        {QStringLiteral("boards-cards"), Words::tr("At a glance"), help("at-a-glance"), PanelPlace::Work,
         [&choice](Bench& bench) -> Panel* { return new CardsPanel(bench, choice); }},
        {QStringLiteral("board"), Words::tr("Device"), help("one-device"), PanelPlace::Work,
         [&choice](Bench& bench) -> Panel* { return new DevicePanel(bench, choice); }},
        {QStringLiteral("boards-plots"), Words::tr("Plots"), help("plots"), PanelPlace::Below,
         [&choice](Bench& bench) -> Panel* { return new PlotsPanel(bench, choice); }},
    };
}

int SmartdeviceView::workHeight() const {
    // Two rows of cards, with what is around panels.
    constexpr int kFrame = 120;
    return 2 * (DeviceCard::kHeight + metrics::kGap) + metrics::kGap + kFrame;
}

std::vector<LinkOffer> SmartdeviceView::offers() const {
    LinkUri simulated;
    simulated.scheme = "sim";
    simulated.target = "smartdevice";
    LinkUri serial;
    serial.scheme = "serial";
    return {
        {Words::tr("Six simulated smart devices"), Words::tr("Start with simulated smart devices"),
         Words::tr("A motor, a battery, switches, a line follower, servos and a team flag of the PiE kit."),
         simulated},
        {Words::tr("Smart devices on USB"), Words::tr("Look for smart devices on USB"),
         Words::tr("Every serial port that is on USB is asked; opening one resets its board."), serial}};
}

bool SmartdeviceView::owns(const SystemSnapshot& system) const {
    return std::holds_alternative<Snapshot>(system);
}

bool SmartdeviceView::isMoving(const SystemSnapshot& system) const {
    return std::ranges::any_of(std::get<Snapshot>(system).devices, &DeviceState::driving);
}

bool SmartdeviceView::isActive(const SystemSnapshot& system) const {
    return isMoving(system);
}

std::vector<StateText> SmartdeviceView::states(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    const int live = countOf(snapshot, Presence::Live);
    const int quiet = countOf(snapshot, Presence::Quiet);
    const int lost = countOf(snapshot, Presence::Lost);
    const QString what =
        session.uri.isSimulated() ? Words::tr("Simulated smart devices") : Words::tr("Smart devices");
    if (snapshot.link != LinkState::Running)
        return {{Tone::Busy, Words::tr("%1 \u00b7 looking for ports").arg(what), {}}};
    const bool asking = std::ranges::any_of(snapshot.ports, [](const PortState& port) {
        return port.phase == PortPhase::Asking || port.phase == PortPhase::Opening;
    });
    const Tone tone = live > 0 ? Tone::Good : asking ? Tone::Busy : Tone::Warning;
    std::vector<StateText> states{
        {tone, Words::tr("%1 \u00b7 %2").arg(what, Words::tr("%n live", nullptr, live)), {}}};
    if (quiet > 0) states.push_back({Tone::Warning, Words::tr("%n stale", nullptr, quiet), {}});
    if (lost > 0) states.push_back({Tone::Danger, Words::tr("%n lost", nullptr, lost), {}});
    return states;
}

const Error* SmartdeviceView::obstacle(const SystemSnapshot&) const {
    // Ports fail one by one, and the list says why.
    return nullptr;
}

QStringList SmartdeviceView::facts(const SessionSnapshot& session) const {
    const auto& snapshot = std::get<Snapshot>(session.system);
    std::uint64_t frames = 0;
    std::uint64_t damaged = 0;
    for (const DeviceState& device : snapshot.devices) {
        frames += device.line.messages;
        damaged += device.line.faults();
    }
    QStringList facts{Words::tr("%1 messages").arg(frames)};
    if (damaged > 0) facts << Words::tr("%1 damaged").arg(damaged);
    return facts;
}

std::vector<Hazard> SmartdeviceView::hazards(const SystemSnapshot&) const {
    return {};
}

QString SmartdeviceView::simulatedText(const LinkUri& uri) const {
    const auto devices = uri.options.find("devices");
    if (devices == uri.options.end()) return Words::tr("six virtual boards");
    return Words::tr("virtual boards: %1").arg(QString::fromStdString(devices->second).replace(u',', u' '));
}

std::vector<int> SmartdeviceView::chosenUnits() const {
    const int unit = choice_->chosenUnit();
    return unit < 0 ? std::vector<int>{} : std::vector{unit};
}

QString SmartdeviceView::actionText(const SimAction& action) const {
    static const std::map<std::string, const char*> texts = {
        {"plugged", QT_TRANSLATE_NOOP("SmartdeviceView", "USB plug")},
        {"reset", QT_TRANSLATE_NOOP("SmartdeviceView", "Reset button")},
        {"silent", QT_TRANSLATE_NOOP("SmartdeviceView", "Answers")},
        {"noise", QT_TRANSLATE_NOOP("SmartdeviceView", "Noise")},
        {"checksum", QT_TRANSLATE_NOOP("SmartdeviceView", "Wrong checksums")},
        {"truncate", QT_TRANSLATE_NOOP("SmartdeviceView", "Cut messages")},
        {"refuse", QT_TRANSLATE_NOOP("SmartdeviceView", "Refused writes")},
        {"switches", QT_TRANSLATE_NOOP("SmartdeviceView", "Pressed switches")},
        {"tape", QT_TRANSLATE_NOOP("SmartdeviceView", "Tape under it")},
        {"dial0", QT_TRANSLATE_NOOP("SmartdeviceView", "Dial 0")},
        {"dial1", QT_TRANSLATE_NOOP("SmartdeviceView", "Dial 1")},
        {"dial2", QT_TRANSLATE_NOOP("SmartdeviceView", "Dial 2")},
        {"speed", QT_TRANSLATE_NOOP("SmartdeviceView", "Joint's speed")},
        {"battery", QT_TRANSLATE_NOOP("SmartdeviceView", "Battery")},
        {"imbalance", QT_TRANSLATE_NOOP("SmartdeviceView", "Imbalance")},
        {"current", QT_TRANSLATE_NOOP("SmartdeviceView", "Current drawn")},
        {"tag", QT_TRANSLATE_NOOP("SmartdeviceView", "Tag near it")},
        {"load", QT_TRANSLATE_NOOP("SmartdeviceView", "Motor's load")},
    };
    const auto found = texts.find(action.name);
    return found == texts.end() ? QString::fromStdString(action.name) : Words::tr(found->second);
}

std::vector<std::pair<QString, double>> SmartdeviceView::actionChoices(const SimAction& action) const {
    if (action.name == "plugged") return {{Words::tr("In"), 1}, {Words::tr("Out"), 0}};
    if (action.name == "reset") return {{Words::tr("Press"), 1}};
    if (action.name == "silent") return {{Words::tr("Yes"), 0}, {Words::tr("Silent"), 1}};
    if (action.name == "switches") {
        return {{Words::tr("None"), 0},    {Words::tr("0"), 1},       {Words::tr("1"), 2},
                {Words::tr("2"), 4},       {Words::tr("0 and 1"), 3}, {Words::tr("0 and 2"), 5},
                {Words::tr("1 and 2"), 6}, {Words::tr("All"), 7}};
    }
    return {};
}

QString SmartdeviceView::unitText(int unit) const {
    const QString kind = choice_->kindOfUnit(unit);
    return kind.isEmpty() ? Words::tr("Board %1").arg(unit) : kind;
}

}  // namespace kickstand::ui
