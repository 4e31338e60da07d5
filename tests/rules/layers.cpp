#include "tests/rules/layers.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace kickstand::rules {
namespace {

// The value types of the systems and links that panels show and send: all that ui/ may name below the engine.
constexpr std::array<std::string_view, 40> kUiValueHeaders{
    "core/coach/commands.h",
    "core/coach/snapshot.h",
    "core/coach/traffic.h",
    "core/coach/wire/velocity.h",
    "core/link/link_uri.h",
    "core/link/sim_action.h",
    "core/motionplan/commands.h",
    "core/motionplan/events.h",
    "core/motionplan/path.h",
    "core/motionplan/plan.h",
    "core/motionplan/snapshot.h",
    "core/motionplan/wire/movement.h",
    "core/motionplan/wire/nxt_status.h",
    "core/motionplan/wire/plan_text.h",
    "core/smartdevice/catalogue.h",
    "core/smartdevice/commands.h",
    "core/smartdevice/events.h",
    "core/smartdevice/snapshot.h",
    "core/thunderbots/types.h",
    "core/thunderbots/commands.h",
    "core/thunderbots/snapshot.h",
    "core/thunderbots/events.h",
    "core/thunderbots/bench_check.h",
    "core/thunderbots/flash_estimate.h",
    "core/thunderbots/flash_plan.h",
    "core/thunderbots/kick_record.h",
    "core/thunderbots/parameters.h",
    "core/thunderbots/parameter_draft.h",
    "core/thunderbots/parameter_state.h",
    "core/thunderbots/sweep_plan.h",
    "core/thunderbots/image/flash_image.h",
    "core/thunderbots/image/image_error.h",
    "core/thunderbots/image/image_file.h",
    "core/thunderbots/wire/dongle.h",
    "core/thunderbots/wire/faults.h",
    "core/thunderbots/wire/kick.h",
    "core/thunderbots/wire/kick_timing.h",
    "core/thunderbots/wire/parameters.h",
    "core/thunderbots/wire/readings.h",
    "core/thunderbots/wire/test_mode.h",
};

struct SharedFolder {
    std::string_view name;
    Layer layer;
};
constexpr std::array<SharedFolder, 8> kSharedFolders{{
    {"base", Layer::Base},
    {"framing", Layer::Framing},
    {"link", Layer::Link},
    {"usbip", Layer::UsbIp},
    {"engine", Layer::Engine},
    {"capture", Layer::Beside},
    {"telemetry", Layer::Beside},
    {"ledger", Layer::Beside},
}};

/// Takes the first segment off a path.
std::string_view takeSegment(std::string_view& path) {
    const std::size_t slash = path.find('/');
    const std::string_view segment = path.substr(0, slash);
    path = slash == std::string_view::npos ? std::string_view{} : path.substr(slash + 1);
    return segment;
}

Place placeInCore(std::string_view rest) {
    const std::string_view folder = takeSegment(rest);
    if (rest.empty()) return {};  // a file in core/ itself
    for (const SharedFolder& shared : kSharedFolders) {
        if (shared.name == folder) return {shared.layer, folder};
    }
    if (rest.starts_with("wire/")) return {Layer::Wire, folder};
    if (rest.starts_with("image/")) return {Layer::Image, folder};
    if (rest.starts_with("sim/")) return {Layer::Sim, folder};
    return {Layer::System, folder};
}

bool isOneOf(Layer layer, std::initializer_list<Layer> layers) {
    return std::ranges::find(layers, layer) != layers.end();
}

bool uiMayInclude(const Place& to, std::string_view header) {
    return isOneOf(to.layer, {Layer::Ui, Layer::UiTraffic, Layer::Engine, Layer::Beside, Layer::Base}) ||
           std::ranges::find(kUiValueHeaders, header) != kUiValueHeaders.end();
}

}  // namespace

Place placeOf(std::string_view path) {
    std::string_view rest = path;
    const std::string_view top = takeSegment(rest);
    if (top == "app") return {Layer::App, {}};
    if (top == "tests") return {Layer::Tests, {}};
    if (top == "ui") return {rest.starts_with("traffic/") ? Layer::UiTraffic : Layer::Ui, {}};
    if (top == "core") return placeInCore(rest);
    return {};
}

bool mayInclude(std::string_view from, std::string_view header) {
    const Place source = placeOf(from);
    const Place to = placeOf(header);
    const bool sameFolder = source.folder == to.folder;
    const bool below = isOneOf(to.layer, {Layer::Framing, Layer::Link, Layer::Base});
    switch (source.layer) {
        case Layer::Other:
        case Layer::Tests:
            return true;
        case Layer::App:
            return to.layer != Layer::Tests;
        case Layer::Ui:
            return uiMayInclude(to, header);
        case Layer::UiTraffic:
            return uiMayInclude(to, header) || to.layer == Layer::Wire;
        case Layer::Engine:
            return below || isOneOf(to.layer,
                                    {Layer::Engine, Layer::System, Layer::Wire, Layer::Image, Layer::Beside});
        case Layer::System:
            return below || (sameFolder && isOneOf(to.layer, {Layer::System, Layer::Wire, Layer::Image}));
        case Layer::Sim:
            return below || (sameFolder && isOneOf(to.layer, {Layer::Sim, Layer::Wire}));
        case Layer::Wire:
        case Layer::Image:
            return isOneOf(to.layer, {Layer::Framing, Layer::Base}) ||
                   (sameFolder && to.layer == source.layer);
        case Layer::Beside:
            return below || (sameFolder && to.layer == Layer::Beside);
        case Layer::UsbIp:
            return isOneOf(to.layer, {Layer::Link, Layer::Base, Layer::UsbIp});
        case Layer::Link:
            return isOneOf(to.layer, {Layer::Link, Layer::Base});
        case Layer::Framing:
            return isOneOf(to.layer, {Layer::Framing, Layer::Base});
        case Layer::Base:
            return to.layer == Layer::Base;
    }
    return false;
}

std::string_view allowanceOf(std::string_view from) {
    switch (placeOf(from).layer) {
        case Layer::Other:
        case Layer::Tests:
            return "anything";
        case Layer::App:
            return "anything but tests";
        case Layer::Ui:
            return "ui, the engine, capture, telemetry, ledger, base, and the value types that layers.cpp "
                   "lists";
        case Layer::UiTraffic:
            return "what ui may include, and every system's wire";
        case Layer::Engine:
            return "systems (not their simulators), capture, telemetry, ledger, framing, link, base";
        case Layer::System:
            return "its own folder, its wire and image, framing, link, base";
        case Layer::Sim:
            return "its own folder, its system's wire, framing, link, base";
        case Layer::Wire:
        case Layer::Image:
            return "its own folder, framing, base";
        case Layer::Beside:
            return "its own folder, framing, link, base";
        case Layer::UsbIp:
            return "its own folder, link, base";
        case Layer::Link:
            return "link and base";
        case Layer::Framing:
            return "framing and base";
        case Layer::Base:
            return "base";
    }
    return "";
}

}  // namespace kickstand::rules
