#include "tests/support/session/request_rig.h"

#include <utility>

#include "core/link/loopback/loopback_usb_link.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using namespace thunderbots;

std::unique_ptr<UsbLink> makeLink(Scheduler& scheduler, UsbDeviceModel& device, MessageFaults::Judge judge) {
    auto link = std::make_unique<LoopbackUsbLink>(scheduler, device);
    if (!judge) return link;
    return std::make_unique<MessageFaults>(std::move(link), scheduler, std::move(judge));
}

}  // namespace

RequestRig::RequestRig(const sim::ThunderbotsSimOptions& options, MessageFaults::Judge judge)
    : sim(scheduler, options),
      link_(makeLink(scheduler, sim.device(), std::move(judge)), scheduler),
      model_(*this, [this](const Event& event) { happened(event); }),
      controller_(scheduler, link_, stop_, [] {}),
      requests(scheduler, controller_.messages()) {
    link_.addObserver(&model_);
    link_.addObserver(this);
    controller_.setMessageListener([this](ByteView packet) { requests.received(packet); });
}

bool RequestRig::connect() {
    controller_.start();
    const bool heard = scheduler.runUntil(
        [this] {
            for (int robot = 0; robot < kRobots; ++robot) {
                if (sim.hasRobot(robot) && !model_.robot(robot).live) return false;
            }
            return controller_.state() == LinkState::Running;
        },
        20s);
    messagesOut_ = 0;
    return heard;
}

void RequestRig::happened(const Event& event) {
    if (event.kind == EventKind::RobotFound) requests.found(event.robot);
    if (event.kind == EventKind::RobotLost)
        requests.lost(event.robot, model_.isOpen() ? Errc::RobotNotAlive : Errc::Disconnected);
}

void RequestRig::observe(const UsbTapRecord& record) {
    if (record.kind == UsbTapRecord::Kind::Completed && record.status == UsbStatus::Completed &&
        !record.setup && record.endpoint == wire::address(wire::Endpoint::MessageOut))
        ++messagesOut_;
}

RobotRequests::Done RequestRig::keepIn(const Ended& ended) {
    return [ended](Result<wire::FirmwareResponse> result) { *ended = std::move(result); };
}

Result<wire::FirmwareResponse> RequestRig::waitFor(const Result<void>& begun, const Ended& ended) {
    if (!begun) return fail(begun.error());
    scheduler.runUntil([&ended] { return ended->has_value(); }, 10min);
    if (!*ended) return fail(Errc::TimedOut, "rig");
    return **ended;
}

Result<wire::FirmwareResponse> RequestRig::ask(int robot, const wire::FirmwareRequest& request) {
    const Ended ended = std::make_shared<Ended::element_type>();
    return waitFor(requests.ask(robot, request, keepIn(ended)), ended);
}

Result<wire::FirmwareResponse> RequestRig::program(int robot, const std::vector<wire::FillPageRequest>& fills,
                                                   const wire::ProgramPageRequest& request) {
    const Ended ended = std::make_shared<Ended::element_type>();
    return waitFor(requests.program(robot, fills, request, keepIn(ended)), ended);
}

}  // namespace kickstand::testing
