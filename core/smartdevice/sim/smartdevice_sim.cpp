#include "core/smartdevice/sim/smartdevice_sim.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace kickstand::smartdevice::sim {
namespace {

constexpr std::int64_t kMostBoards = 32;
constexpr std::uint8_t kSeason = 8;
constexpr char kDefaultDevices[] = "PolarBear,BatteryBuzzer,LimitSwitch,LineFollower,ServoControl,TeamFlag";

const BodyKind* findKind(std::string_view name) {
    const auto found =
        std::ranges::find_if(bodyKinds(), [name](const BodyKind& kind) { return name == kind.name; });
    return found == bodyKinds().end() ? nullptr : &*found;
}

Error outOfRange(const std::string& subject, const std::string& text, std::int64_t highest) {
    return {.code = Errc::OutOfRange, .subject = subject, .lowest = 0, .highest = highest, .detail = text};
}

Result<double> readNumber(const std::string& name, const std::string& text, double highest) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return fail(Errc::BadArgument, name, text);
    if (value < 0 || value > highest) return fail(outOfRange(name, text, static_cast<std::int64_t>(highest)));
    return value;
}

Result<std::vector<BoardOptions>> readBoards(std::string_view text) {
    std::vector<BoardOptions> boards;
    for (bool more = true; more;) {
        const std::size_t comma = text.find(',');
        std::string_view piece = text.substr(0, comma);
        more = comma != std::string_view::npos;
        if (more) text.remove_prefix(comma + 1);
        BoardOptions board;
        if (piece.ends_with(".hibike")) {
            board.dialect = wire::Dialect::Hibike;
            piece.remove_suffix(std::string_view(".hibike").size());
        }
        if (piece.empty()) return fail(Errc::BadArgument, "devices", "a name is missing");
        if (findKind(piece) == nullptr) return fail(Errc::UnknownName, std::string(piece), knownKinds());
        board.kind = piece;
        boards.push_back(std::move(board));
    }
    if (boards.size() > static_cast<std::size_t>(kMostBoards))
        return fail(outOfRange("devices", std::to_string(boards.size()), kMostBoards));
    return boards;
}

wire::Uid uidOf(const BodyKind& kind, wire::Dialect dialect, int number) {
    wire::Uid uid;
    uid.dialect = dialect;
    const std::size_t season = dialect == wire::Dialect::Current ? 1 : 2;
    uid.bytes[0] = kind.id;
    uid.bytes.at(season) = kSeason;
    for (std::size_t i = season + 1; i < wire::kUidSize; ++i)
        uid.bytes.at(i) =
            static_cast<std::uint8_t>(i == season + 1 ? number + 1 : static_cast<int>(0x10 + i));
    return uid;
}

struct NumberOption {
    std::string_view name;
    double highest;
};
constexpr std::array kNumbers{NumberOption{"boot_ms", 10'000}, NumberOption{"noise", 1},
                              NumberOption{"seed", 4294967295.0}, NumberOption{"data_bytes", 253}};

struct FaultAction {
    const char* name;
    double BoardFaults::*probability;
};
constexpr std::array kFaults{
    FaultAction{"noise", &BoardFaults::noise}, FaultAction{"checksum", &BoardFaults::checksum},
    FaultAction{"truncate", &BoardFaults::truncate}, FaultAction{"refuse", &BoardFaults::refuse}};

}  // namespace

std::string knownKinds() {
    std::string names;
    for (const BodyKind& kind : bodyKinds())
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

Result<SmartDeviceSimOptions> parseSimOptions(const LinkUri& uri) {
    SmartDeviceSimOptions options;
    const auto devices = uri.options.find("devices");
    auto boards =
        readBoards(devices == uri.options.end() ? kDefaultDevices : std::string_view(devices->second));
    if (!boards) return fail(std::move(boards.error()));
    options.boards = std::move(*boards);
    for (const auto& [name, text] : uri.options) {
        if (name == "devices") continue;
        const auto* const known = std::ranges::find(kNumbers, name, &NumberOption::name);
        if (known == kNumbers.end())
            return fail(Errc::UnknownName, name, "devices, boot_ms, noise, seed, data_bytes");
        const auto value = readNumber(name, text, known->highest);
        if (!value) return fail(value.error());
        if (name == "noise") options.noise = *value;
        if (name == "boot_ms") options.boot = fromSeconds(*value / 1000);
        if (name == "data_bytes") options.longestData = static_cast<std::size_t>(*value);
        if (name == "seed") options.seed = static_cast<std::uint32_t>(*value);
    }
    return options;
}

SmartDeviceSim::SmartDeviceSim(Scheduler& scheduler, const SmartDeviceSimOptions& options) {
    for (const BoardOptions& board : options.boards) {
        const int number = count();
        const BodyKind& kind = *findKind(board.kind);
        boards_.push_back(std::make_unique<BoardSim>(scheduler, uidOf(kind, board.dialect, number),
                                                     kind.make(), options.boot,
                                                     options.seed + static_cast<std::uint32_t>(number)));
        boards_.back()->body().connectTo(supply_);
        boards_.back()->setLongestData(options.longestData);
        kinds_.push_back(board.kind);
    }
}

std::string SmartDeviceSim::portName(int number) const {
    return "simulated-" + std::to_string(number);
}

std::vector<SimAction> SmartDeviceSim::actions() const {
    std::vector<SimAction> all{
        {"plugged", true, "0 or 1", 0, 1}, {"reset", true, "1", 1, 1}, {"silent", true, "0 or 1", 0, 1}};
    for (const FaultAction& fault : kFaults)
        all.push_back({fault.name, true, "probability", 0, 1});
    for (const auto& board : boards_) {
        for (const SimQuantity& quantity : board->body().quantities()) {
            if (std::ranges::find(all, quantity.name, &SimAction::name) == all.end())
                all.push_back({quantity.name, true, quantity.unit, quantity.lowest, quantity.highest});
        }
    }
    return all;
}

std::vector<int> SmartDeviceSim::units() const {
    std::vector<int> all(boards_.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<int>(i);
    return all;
}

Result<void> SmartDeviceSim::perform(std::string_view action, int unit, double value) {
    const std::vector<SimAction> known = actions();
    const auto found = std::ranges::find(known, action, &SimAction::name);
    if (found == known.end()) return fail(Errc::UnknownName, std::string(action));
    if (!(value >= found->lowest && value <= found->highest)) {
        Error error =
            outOfRange(std::string(action), std::to_string(value), static_cast<std::int64_t>(found->highest));
        error.lowest = static_cast<std::int64_t>(found->lowest);
        return fail(std::move(error));
    }
    if (unit >= count() || unit < -1) return fail(Errc::BadArgument, "device", std::to_string(unit));
    if (unit >= 0) return performOn(action, unit, value);
    for (int each = 0; each < count(); ++each)
        static_cast<void>(performOn(action, each, value));
    return {};
}

Result<void> SmartDeviceSim::performOn(std::string_view action, int unit, double value) {
    BoardSim& board = this->board(unit);
    if (action == "plugged") {
        board.plug(value != 0);
        if (plugged_) plugged_();
        return {};
    }
    if (action == "reset") {
        board.reset();
        return {};
    }
    if (action == "silent") {
        board.faults().silent = value != 0;
        return {};
    }
    for (const FaultAction& fault : kFaults) {
        if (action != fault.name) continue;
        board.faults().*fault.probability = value;
        return {};
    }
    const auto quantities = board.body().quantities();
    const bool has =
        std::ranges::any_of(quantities, [&](const SimQuantity& one) { return action == one.name; });
    if (!has) return fail(Errc::BadArgument, std::string(action), "that board has none");
    board.body().setQuantity(action, value);
    return {};
}

std::optional<double> SmartDeviceSim::value(std::string_view action, int unit) const {
    if (unit < 0 || unit >= count()) return std::nullopt;
    BoardSim& board = *boards_[static_cast<std::size_t>(unit)];
    if (action == "plugged") return board.attached() ? 1 : 0;
    if (action == "silent") return board.faults().silent ? 1 : 0;
    for (const FaultAction& fault : kFaults) {
        if (action == fault.name) return board.faults().*fault.probability;
    }
    for (const SimQuantity& quantity : board.body().quantities()) {
        if (action == quantity.name) return board.body().quantity(action);
    }
    return std::nullopt;
}

}  // namespace kickstand::smartdevice::sim
