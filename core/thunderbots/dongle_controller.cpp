#include "core/thunderbots/dongle_controller.h"

#include <memory>
#include <utility>

namespace kickstand::thunderbots {
namespace {

using wire::address;
using wire::Endpoint;

constexpr Duration kControlDeadline = std::chrono::seconds(1);
/// Two radios are reset and set up one after the other; a dongle that is not done by then hangs.
constexpr Duration kStartDeadline = std::chrono::seconds(10);
/// A device that may not be opened now is tried again this often: the rule may be installed, the other
/// program ended.
constexpr Duration kRetryEvery = std::chrono::seconds(1);
/// How long braked blocks may take to go before a link is given up all the same.
constexpr Duration kLastBlocksDeadline = std::chrono::milliseconds(200);
/// Packets that may come in while the engine is busy.
constexpr int kDepth = 4;

/// Whether waiting can mend it without a person touching this program.
bool mendsItself(Errc code) {
    return code == Errc::PermissionDenied || code == Errc::ClaimedElsewhere || code == Errc::SeveralDevices ||
           code == Errc::Io;
}

}  // namespace

DongleController::DongleController(Scheduler& scheduler, UsbLink& link, const StopLatch& stop,
                                   std::function<void()> changed)
    : scheduler_(scheduler),
      link_(link),
      changed_(std::move(changed)),
      stateTransport_(link, scheduler, stop, [this](Error error) { giveUp(std::move(error)); }),
      messages_(link, scheduler, stop, [this](Error error) { giveUp(std::move(error)); }),
      status_(
          link, address(Endpoint::Status), wire::kStatusBytes, 1,
          [this](ByteView packet) { statusReceived(packet); },
          [this](Error error) { giveUp(std::move(error)); }),
      errors_(link, address(Endpoint::ErrorQueue), wire::kPacketBytes, 1, {},
              [this](Error error) { giveUp(std::move(error)); }),
      text_(link, address(Endpoint::DebugText), wire::kPacketBytes, 1, {},
            [this](Error error) { giveUp(std::move(error)); }),
      stateIn_(link, address(Endpoint::StateIn), wire::kPacketBytes, kDepth, {},
               [this](Error error) { giveUp(std::move(error)); }),
      messageIn_(
          link, address(Endpoint::MessageIn), wire::kPacketBytes, kDepth,
          [this](ByteView packet) {
              if (messageReceived_) messageReceived_(packet);
          },
          [this](Error error) { giveUp(std::move(error)); }) {
    link_.setPresenceListener([this](bool present) { presence(present); });
}

DongleController::~DongleController() {
    scheduler_.cancel(deadline_);
    scheduler_.cancel(retry_);
}

void DongleController::setState(LinkState state) {
    state_ = state;
    changed_();
}

void DongleController::start(std::optional<wire::Channels> channels) {
    channels_ = channels;
    wanted_ = true;
    openLink();
}

void DongleController::openLink() {
    scheduler_.cancel(std::exchange(retry_, 0));
    const std::uint64_t attempt = ++attempt_;
    if (!error_) state_ = LinkState::Opening;
    opening_ = true;
    appeared_ = false;
    link_.open([this, attempt](Result<UsbDeviceInfo> result) { opened(attempt, std::move(result)); });
}

void DongleController::opened(std::uint64_t attempt, Result<UsbDeviceInfo> result) {
    opening_ = false;
    if (attempt != attempt_ || !wanted_) return;
    if (!result) {
        const Errc code = result.error().code;
        if (code == Errc::NoDevice || code == Errc::Disconnected) {
            error_.reset();
            if (appeared_) {
                openLink();
                return;
            }
            // Why, where more is known than that there is none.
            if (!result.error().detail.empty()) error_ = std::move(result.error());
            setState(LinkState::Searching);
            return;
        }
        error_ = std::move(result.error());
        if (mendsItself(code)) retryLater();
        setState(LinkState::Failed);
        return;
    }
    device_ = std::move(*result);
    error_.reset();
    armDeadline();
    setState(LinkState::Starting);
    if (isCable()) {
        status_.open();
        requestStatus();
    } else {
        startRadios();
    }
}

void DongleController::armDeadline() {
    scheduler_.cancel(deadline_);
    deadline_ = scheduler_.callAfter(kStartDeadline, [this] {
        deadline_ = 0;
        startFailed(Errc::TimedOut, "start-up");
    });
}

void DongleController::retryLater() {
    scheduler_.cancel(retry_);
    retry_ = scheduler_.callAfter(kRetryEvery, [this] {
        retry_ = 0;
        if (wanted_) openLink();
    });
}

void DongleController::presence(bool present) {
    if (!wanted_) return;
    if (present) {
        if (opening_) {
            // The answer on its way may still be about the time before.
            appeared_ = true;
        } else if (state_ == LinkState::Searching || state_ == LinkState::Failed) {
            openLink();
        }
        return;
    }
    ++attempt_;
    stopTransfers(Error{.code = Errc::Disconnected});
    // Whoever waited for the last blocks may have closed it.
    if (!wanted_) return;
    error_.reset();
    setState(LinkState::Searching);
}

void DongleController::request(wire::VendorRequest request, std::uint16_t value,
                               std::function<void(UsbStatus)> done) {
    const UsbSetup setup{wire::kVendorOut, static_cast<std::uint8_t>(request), value, 0, 0};
    link_.control(setup, {}, kControlDeadline,
                  [this, attempt = attempt_, done = std::move(done)](const UsbCompletion& completion) {
                      if (attempt == attempt_) done(completion.status);
                  });
}

void DongleController::read(wire::VendorRequest request, std::uint16_t length) {
    // Only the model wants the answer, and it reads it on the tap.
    const UsbSetup setup{wire::kVendorIn, static_cast<std::uint8_t>(request), 0, 0, length};
    link_.control(setup, {}, kControlDeadline, [](const UsbCompletion&) {});
}

void DongleController::startRadios() {
    if (const auto channels = std::exchange(channels_, std::nullopt)) {
        const auto value = wire::encodeChannelsValue(*channels);
        if (!value) {
            giveUp(wire::toError(value.error(), "channels"));
            return;
        }
        request(wire::VendorRequest::SetChannels, *value, [this](UsbStatus status) {
            if (status == UsbStatus::Completed) {
                startRadios();
            } else {
                startFailed(Errc::ChannelsLocked, name(status));
            }
        });
        return;
    }
    request(wire::VendorRequest::EnableRadios, 0, [this](UsbStatus status) {
        if (status != UsbStatus::Completed) {
            startFailed(Errc::RadioFailed, name(status));
            return;
        }
        status_.open();
        requestStatus();
    });
}

void DongleController::requestStatus() {
    request(wire::VendorRequest::ResendStatus, 0, [this](UsbStatus status) {
        // A cable has no such request to answer; it says its status of its own accord.
        if (status != UsbStatus::Completed && !isCable()) startFailed(Errc::Io, name(status));
    });
}

void DongleController::statusReceived(ByteView packet) {
    const auto status = wire::decodeStatus(packet);
    if (!status) return;
    if (status->radios == wire::RadioState::Radio0Failed) {
        startFailed(Errc::RadioFailed, "radio 0", 0);
    } else if (status->radios == wire::RadioState::Radio1Failed) {
        startFailed(Errc::RadioFailed, "radio 1", 1);
    } else if (status->radios == wire::RadioState::Running && state_ == LinkState::Starting) {
        radiosRunning();
    }
}

void DongleController::radiosRunning() {
    setState(LinkState::Braking);
    stateTransport_.open();
    stateTransport_.brakeAll();
    stateTransport_.whenDrained([this](bool taken) {
        if (taken) allBraked();
    });
}

void DongleController::allBraked() {
    scheduler_.cancel(std::exchange(deadline_, 0));
    errors_.open();
    text_.open();
    stateIn_.open();
    messageIn_.open();
    messages_.open();
    if (!isCable()) {
        read(wire::VendorRequest::ReadChannels, wire::kChannelsBytes);
        read(wire::VendorRequest::ReadRadioVersions, wire::kRadioVersionsBytes);
    }
    setState(LinkState::Running);
}

void DongleController::startFailed(Errc code, std::string subject, std::optional<int> radio) {
    Error error;
    error.code = code;
    error.subject = std::move(subject);
    if (radio) error.got = *radio;
    giveUp(std::move(error));
}

void DongleController::giveUp(Error error) {
    if (state_ == LinkState::Failed || state_ == LinkState::Idle) return;
    if (state_ == LinkState::Running && error.endpoint != address(Endpoint::StateOut)) {
        brakeThenFail(std::move(error));
    } else {
        failNow(std::move(error));
    }
}

void DongleController::brakeThenFail(Error error) {
    // The way out still works, and without these blocks robots would go on until the dongle's dead-man.
    setState(LinkState::Braking);
    stateTransport_.brakeAll();
    const auto failing = std::make_shared<Error>(std::move(error));
    deadline_ = scheduler_.callAfter(kLastBlocksDeadline, [this, failing] {
        deadline_ = 0;
        failNow(*failing);
    });
    stateTransport_.whenDrained([this, failing, attempt = attempt_](bool) {
        if (attempt == attempt_) failNow(*failing);
    });
}

void DongleController::failNow(Error error) {
    ++attempt_;
    stopTransfers(error);
    if (!wanted_) return;
    error_ = std::move(error);
    link_.close([] {});
    setState(LinkState::Failed);
}

void DongleController::stopTransfers(const Error& why) {
    scheduler_.cancel(std::exchange(deadline_, 0));
    scheduler_.cancel(std::exchange(retry_, 0));
    status_.close();
    errors_.close();
    text_.close();
    stateIn_.close();
    messageIn_.close();
    stateTransport_.close();
    messages_.close(why);
}

void DongleController::close(std::function<void()> done) {
    ++attempt_;
    wanted_ = false;
    stopTransfers(Error{.code = Errc::Cancelled});
    error_.reset();
    state_ = LinkState::Idle;
    link_.close(std::move(done));
}

}  // namespace kickstand::thunderbots
