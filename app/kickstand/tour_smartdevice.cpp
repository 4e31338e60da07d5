#include <QListWidget>
#include <algorithm>

#include "app/kickstand/tour_maker.h"
#include "core/link/link_uri.h"
#include "core/smartdevice/commands.h"
#include "ui/smartdevice/smartdevice_view.h"

namespace kickstand::app {

namespace {

using namespace smartdevice;

constexpr std::size_t kBoards = 6;
/// Of the default boards in the simulator.
constexpr int kBattery = 1;
constexpr int kSwitches = 2;
constexpr int kLineFollower = 3;
constexpr std::uint64_t kSamplesToShow = 250;

TourMaker::Done whenBoards(ui::Bench* bench, bool (*holds)(const Snapshot&)) {
    return [bench, holds] {
        const Snapshot* const snapshot = ui::boardsOf(bench->session());
        return snapshot != nullptr && holds(*snapshot);
    };
}

const DeviceState* boardOf(const Snapshot& snapshot, std::string_view kind) {
    const auto found = std::ranges::find_if(
        snapshot.devices, [kind](const DeviceState& device) { return device.spec->name == kind; });
    return found == snapshot.devices.end() ? nullptr : &*found;
}

/// Chooses a board in the list, as a person would.
TourMaker::Act choose(ui::MainWindow* window, ui::Bench* bench, const char* kind) {
    return [window, bench, kind] {
        const DeviceState* board = boardOf(*ui::boardsOf(bench->session()), kind);
        if (board != nullptr)
            window->findChild<QListWidget*>(QStringLiteral("boards"))->setCurrentRow(board->number);
    };
}

/// Writes what the editors cannot be told without a mouse.
TourMaker::Act write(ui::Bench* bench, const char* kind,
                     std::vector<std::pair<const char*, wire::Value>> values) {
    return [bench, kind, values = std::move(values)] {
        const DeviceState* board = boardOf(*ui::boardsOf(bench->session()), kind);
        if (board == nullptr) return;
        WriteValues command{board->number, {}};
        for (const auto& [name, value] : values)
            command.values.emplace_back(board->spec->find(name), value);
        bench->submit(smartdevice::Command(command));
    };
}

bool allTold(const Snapshot& snapshot) {
    return snapshot.devices.size() == kBoards &&
           std::ranges::all_of(snapshot.devices, [](const DeviceState& device) {
               return device.latency.has_value() && device.samples > 20;
           });
}

}  // namespace

namespace {

void addLooking(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    ui::MainWindow* const window = tour.window();
    tour.add("boards-motor", write(bench, "PolarBear", {{"duty_cycle", 0.4F}, {"current_thresh", 3.0F}}),
             whenBoards(bench, [](const Snapshot& snapshot) {
                 return boardOf(snapshot, "PolarBear")->parameters[0].verdict == WriteVerdict::Done;
             }));
    tour.add("boards-servos", write(bench, "ServoControl", {{"servo0", 0.4F}, {"servo1", -0.5F}}));
    tour.add("boards-flag",
             write(bench, "TeamFlag",
                   {{"mode", true}, {"blue", true}, {"led1", true}, {"led2", true}, {"led3", true}}),
             whenBoards(bench, [](const Snapshot& snapshot) {
                 return boardOf(snapshot, "TeamFlag")->parameters[0].verdict == WriteVerdict::Done;
             }));
    tour.add("boards-switches", tour.simulate("switches", kSwitches, 5));
    // So long that its curves show how it got up to speed.
    tour.show("boards", tour.goTo("boards-cards"), whenBoards(bench, [](const Snapshot& snapshot) {
                  return boardOf(snapshot, "PolarBear")->samples > kSamplesToShow;
              }));
    tour.add("board-choose", choose(window, bench, "PolarBear"));
    tour.show("board", tour.goTo("board"));
}

void addTrouble(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    ui::MainWindow* const window = tour.window();
    tour.show(
        "boards-stopped", [bench] { bench->client().stop(StopReason::Person); },
        whenBoards(bench, [](const Snapshot& snapshot) {
            return snapshot.blocked &&
                   boardOf(snapshot, "PolarBear")->parameters[0].value == wire::Value(0.0F);
        }));
    tour.add(
        "boards-re-arm", [bench] { bench->client().rearm(); },
        [bench] { return !bench->client().isStopped(); });
    tour.add("boards-unplug", tour.simulate("plugged", kLineFollower, 0),
             whenBoards(bench, [](const Snapshot& snapshot) {
                 return boardOf(snapshot, "LineFollower")->presence == Presence::Lost;
             }));
    tour.add("boards-battery", tour.simulate("battery", kBattery, 10),
             whenBoards(bench, [](const Snapshot& s) {
                 return boardOf(s, "BatteryBuzzer")->parameters[0].value == wire::Value(true);
             }));
    tour.show("boards-trouble", tour.goTo("boards-cards"));
    tour.add("boards-simulate", choose(window, bench, "BatteryBuzzer"));
    tour.show("boards-simulated", tour.goTo("simulated"), [window] {
        return window->findChild<QWidget*>(QStringLiteral("sim-battery-%1").arg(kBattery)) != nullptr;
    });
}

}  // namespace

void addSmartdeviceSteps(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    tour.add(
        "boards-connect", [bench] { bench->connectTo(*parseLinkUri("sim:smartdevice")); },
        whenBoards(bench, allTold));
    addLooking(tour);
    addTrouble(tour);
    tour.add(
        "boards-disconnect", [bench] { bench->disconnectAll(); },
        [bench] { return bench->session() == nullptr; });
}

}  // namespace kickstand::app
