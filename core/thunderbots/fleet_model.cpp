#include "core/thunderbots/fleet_model.h"

#include <utility>

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots {
namespace {

using wire::address;
using wire::Endpoint;

/// Damage is told at most this often; in between it is counted.
constexpr Duration kMalformedTellEvery = std::chrono::milliseconds(200);
/// A line of debug text that is longer is told in pieces.
constexpr std::size_t kLongestTextLine = 256;
constexpr Duration kRateWindow = std::chrono::seconds(1);

template <std::size_t... n>
std::array<RobotModel, sizeof...(n)> makeRobots(SampleSink& samples,
                                                const std::function<void(const Event&)>& event,
                                                std::index_sequence<n...>) {
    return {RobotModel(static_cast<int>(n), samples, event)...};
}

}  // namespace

FleetModel::FleetModel(SampleSink& samples, std::function<void(const Event&)> event)
    : event_(std::move(event)), robots_(makeRobots(samples, event_, std::make_index_sequence<kRobots>())) {}

void FleetModel::raise(EventKind kind, TimePoint time, std::int64_t code, std::int64_t previous,
                       std::string text) {
    event_(Event{kind, time, -1, code, previous, 0, std::move(text)});
}

void FleetModel::observe(const UsbTapRecord& record) {
    using Kind = UsbTapRecord::Kind;
    switch (record.kind) {
        case Kind::Opened:
            connectionBegan();
            break;
        case Kind::Closed:
        case Kind::Lost:
            connectionEnded(record.time);
            break;
        case Kind::Submitted:
            return;
        case Kind::Completed:
            if (record.status == UsbStatus::Stalled) ++traffic_.stalls;
            if (record.setup) {
                completedControl(record);
            } else if (isInEndpoint(record.endpoint)) {
                completedIn(record);
            } else {
                completedOut(record);
            }
            break;
    }
    ++version_;
}

void FleetModel::connectionBegan() {
    open_ = true;
    status_ = {};
    channels_.reset();
    radioVersions_.reset();
    text_.clear();
    for (RobotModel& robot : robots_)
        robot.connectionBegan();
}

void FleetModel::connectionEnded(TimePoint time) {
    if (!open_) return;
    open_ = false;
    refreshLive(time);
    tellMalformed(time);
    if (!text_.empty()) raise(EventKind::DongleText, time, 0, 0, std::exchange(text_, {}));
    status_ = {};
}

void FleetModel::refreshLive(TimePoint time) {
    const bool healthy = open_ && status_.radios == wire::RadioState::Running;
    for (int robot = 0; robot < kRobots; ++robot)
        at(robot).setLive(healthy && contains(status_.aliveRobots, robot), time);
}

void FleetModel::completedControl(const UsbTapRecord& record) {
    if (record.status != UsbStatus::Completed) return;
    const auto request = static_cast<wire::VendorRequest>(record.setup->request);
    if (record.setup->requestType == wire::kVendorIn && request == wire::VendorRequest::ReadChannels) {
        if (const auto channels = wire::decodeChannels(record.data)) {
            channels_ = *channels;
        } else {
            malformed(0, channels.error(), record.time);
        }
    } else if (record.setup->requestType == wire::kVendorIn &&
               request == wire::VendorRequest::ReadRadioVersions) {
        if (const auto versions = wire::decodeRadioVersions(record.data)) {
            radioVersions_ = *versions;
        } else {
            malformed(0, versions.error(), record.time);
        }
    }
}

void FleetModel::completedOut(const UsbTapRecord& record) {
    if (record.status != UsbStatus::Completed) return;
    ++traffic_.packetsOut;
    if (record.endpoint == address(Endpoint::StateOut)) stateSent(record.data, record.time);
    if (record.endpoint == address(Endpoint::MessageOut)) messageSent(record.data, record.time);
}

void FleetModel::completedIn(const UsbTapRecord& record) {
    if (record.status == UsbStatus::Overflow) {
        malformed(record.endpoint,
                  {wire::WireFault::TooLong, "length", 0, wire::kPacketBytes,
                   static_cast<std::int32_t>(record.actual)},
                  record.time);
    }
    if (record.status != UsbStatus::Completed) return;
    ++traffic_.packetsIn;
    switch (static_cast<Endpoint>(record.endpoint)) {
        case Endpoint::Status:
            statusReceived(record.data, record.time);
            break;
        case Endpoint::ErrorQueue:
            errorsReceived(record.data, record.time);
            break;
        case Endpoint::DebugText:
            textReceived(record.data, record.time);
            break;
        case Endpoint::StateIn:
            stateReceived(record.data, record.time);
            break;
        case Endpoint::MessageIn:
            messageReceived(record.data, record.time);
            break;
        default:
            break;
    }
}

void FleetModel::statusReceived(ByteView packet, TimePoint time) {
    const auto status = wire::decodeStatus(packet);
    if (!status) {
        malformed(address(Endpoint::Status), status.error(), time);
        return;
    }
    const wire::DongleStatus before = std::exchange(status_, *status);
    if (status->eStop != before.eStop)
        raise(EventKind::EmergencyStop, time, static_cast<int>(status->eStop),
              static_cast<int>(before.eStop));
    if (status->radios != before.radios)
        raise(EventKind::Radios, time, static_cast<int>(status->radios), static_cast<int>(before.radios));
    refreshLive(time);
}

void FleetModel::errorsReceived(ByteView packet, TimePoint time) {
    for (const std::uint8_t code : packet) {
        ++traffic_.dongleErrors;
        raise(EventKind::DongleFault, time, code);
    }
}

void FleetModel::textReceived(ByteView packet, TimePoint time) {
    for (const std::uint8_t byte : packet) {
        if (byte == '\n' || text_.size() == kLongestTextLine) {
            if (!text_.empty()) raise(EventKind::DongleText, time, 0, 0, std::exchange(text_, {}));
            if (byte == '\n') continue;
        }
        if (byte == '\r') continue;
        text_ += byte >= 0x20 && byte < 0x7F ? static_cast<char>(byte) : '?';
    }
}

void FleetModel::stateReceived(ByteView packet, TimePoint time) {
    wire::MicropacketReader reader(packet, wire::Direction::In);
    while (const auto next = reader.next()) {
        if (!*next) {
            malformed(address(Endpoint::StateIn), next->error(), time);
            return;
        }
        const auto block = wire::decodeFeedback((*next)->payload);
        if (block) {
            at((*next)->robot).feedback(*block, time);
        } else {
            malformed(address(Endpoint::StateIn), block.error(), time);
        }
    }
}

void FleetModel::messageReceived(ByteView packet, TimePoint time) {
    const auto message = wire::decodeMessagePacket(packet, wire::Direction::In);
    if (!message) {
        malformed(address(Endpoint::MessageIn), message.error(), time);
        return;
    }
    if (message->pipe != wire::Pipe::Indicator) return;
    const auto indicator = wire::decodeIndicator(message->payload);
    if (indicator) {
        at(message->robot).indicator(*indicator, time);
        return;
    }
    if (indicator.error().fault == wire::WireFault::BadValue) at(message->robot).experimentRejected();
    malformed(address(Endpoint::MessageIn), indicator.error(), time);
}

void FleetModel::stateSent(ByteView packet, TimePoint time) {
    wire::MicropacketReader reader(packet, wire::Direction::Out);
    while (const auto next = reader.next()) {
        if (!*next) {
            malformed(address(Endpoint::StateOut), next->error(), time);
            return;
        }
        const auto block = wire::decodeDrive((*next)->payload);
        if (block) {
            at((*next)->robot).told(*block, time);
        } else {
            malformed(address(Endpoint::StateOut), block.error(), time);
        }
    }
}

void FleetModel::messageSent(ByteView packet, TimePoint time) {
    const auto message = wire::decodeMessagePacket(packet, wire::Direction::Out);
    if (!message) {
        malformed(address(Endpoint::MessageOut), message.error(), time);
        return;
    }
    if (message->pipe == wire::Pipe::Kick) {
        if (const auto kick = wire::decodeKick(message->payload)) at(message->robot).kickGiven(*kick, time);
    } else if (message->pipe == wire::Pipe::TestMode) {
        if (const auto mode = wire::decodeTestMode(message->payload))
            at(message->robot).testModeGiven(*mode, time);
    }
}

void FleetModel::malformed(std::uint8_t endpoint, const wire::WireError& error, TimePoint time) {
    ++traffic_.malformed;
    ++malformedUntold_;
    malformedEndpoint_ = endpoint;
    malformedText_ =
        std::string(wire::name(error.fault)) + " " + error.field + ": " + std::to_string(error.got);
    if (!malformedToldAt_ || time - *malformedToldAt_ >= kMalformedTellEvery) tellMalformed(time);
}

void FleetModel::tellMalformed(TimePoint time) {
    if (malformedUntold_ == 0) return;
    malformedToldAt_ = time;
    event_(Event{EventKind::Malformed, time, -1, malformedEndpoint_, 0,
                 static_cast<double>(std::exchange(malformedUntold_, 0)), malformedText_});
}

void FleetModel::tick(TimePoint now) {
    if (malformedToldAt_ && now - *malformedToldAt_ >= kMalformedTellEvery) tellMalformed(now);
    if (now - rateSince_ < kRateWindow) return;
    const std::uint64_t total = traffic_.packetsIn + traffic_.packetsOut;
    const double rate = static_cast<double>(total - rateFrom_) / seconds(now - rateSince_);
    if (rate != traffic_.packets_per_s) ++version_;
    traffic_.packets_per_s = rate;
    rateFrom_ = total;
    rateSince_ = now;
}

}  // namespace kickstand::thunderbots
