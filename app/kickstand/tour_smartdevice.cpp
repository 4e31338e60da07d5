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

void addSmartdeviceSteps(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    ui::MainWindow* const window = tour.window();
    tour.add(
        "boards-connect", [bench] { bench->connectTo(*parseLinkUri("sim:smartdevice")); },
        whenBoards(bench, allTold));
    tour.add("boards-write", write(bench, "PolarBear", {{"duty_cycle", 0.4F}, {"current_thresh", 3.0F}}),
             whenBoards(bench, [](const Snapshot& snapshot) {
                 const DeviceState& motor = *boardOf(snapshot, "PolarBear");
                 return motor.parameters[0].verdict == WriteVerdict::Done;
             }));
    tour.show("board", choose(window, bench, "PolarBear"));
    tour.show(
        "boards-stopped", [bench] { bench->client().stop(StopReason::Person); },
        whenBoards(bench, [](const Snapshot& snapshot) { return snapshot.blocked; }));
    tour.add(
        "boards-re-arm", [bench] { bench->client().rearm(); },
        [bench] { return !bench->client().isStopped(); });
    tour.add(
        "boards-disconnect", [bench] { bench->disconnectAll(); },
        [bench] { return bench->session() == nullptr; });
}

}  // namespace kickstand::app
