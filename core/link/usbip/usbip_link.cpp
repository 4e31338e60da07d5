#include "core/link/usbip/usbip_link.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/link/socket/sockets.h"
#include "core/link/usb_packet_check.h"
#include "core/link/usbip/usbip_client.h"
#include "core/link/usbip/usbip_presence.h"
#include "core/link/usbip/usbip_setup.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;

constexpr Duration kConnectDeadline = 3s;
/// For everything between the connection and the configured device.
constexpr Duration kSetupDeadline = 10s;
/// How long the server may take over the unlinks of a link that closes.
constexpr Duration kCloseDeadline = 1s;
constexpr Duration kClearHaltDeadline = 3s;
/// A server takes a moment to notice that a client has gone: a link that had the device or asked for it this
/// lately asks again when it is in use.
constexpr Duration kReleaseTime = 2s;
constexpr Duration kBusyRetry = 50ms;

constexpr std::uint8_t kToEndpoint = 2;
constexpr std::uint8_t kClearFeature = 1;

/// The interval of an endpoint as a transfer carries it: in frames, or in microframes from high speed on,
/// where the descriptor has its logarithm.
std::uint32_t intervalOf(const UsbEndpointInfo& endpoint, usbip::Speed speed) {
    if (endpoint.type != UsbEndpointInfo::Type::Interrupt) return 0;
    const std::uint32_t interval = std::max<std::uint32_t>(endpoint.interval_ms, 1);
    if (speed == usbip::Speed::LowSpeed || speed == usbip::Speed::FullSpeed) return interval;
    constexpr std::uint32_t kLargest = 16;
    return 1U << (std::min(interval, kLargest) - 1);
}

class UsbipLink final : public UsbLink {
  public:
    UsbipLink(Scheduler& scheduler, const UsbipAddress& address, UsbMatch match, UsbipConnect connect);
    ~UsbipLink() override;
    UsbipLink(const UsbipLink&) = delete;
    UsbipLink& operator=(const UsbipLink&) = delete;

    void open(std::function<void(Result<UsbDeviceInfo>)> done) override;
    void close(std::function<void()> done) override;
    void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) override;
    Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) override;
    Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) override;
    void cancel(UsbTransferId id) override;
    void clearHalt(std::uint8_t endpoint, UsbCallback done) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;
    UsbLinkHealth health() const override;

  private:
    enum class State : std::uint8_t { Closed, Opening, Open, Closing, Losing };

    struct Pending {
        UsbCallback done;
        UsbipClient::Sequence sequence = 0;
        TimerId deadline = 0;
        bool timedOut = false;
    };

    void attempt();
    void connected(Result<std::unique_ptr<ByteStream>> stream);
    void imported(const Result<usbip::Device>& device);
    void openEnded(Result<UsbipDevice> opened);
    void shut(std::optional<bool> there);
    void lost(const Error& why);
    void forceClose();

    const UsbEndpointInfo* find(std::uint8_t endpoint) const;
    Result<UsbTransferId> submit(std::uint8_t endpoint, UsbDirection direction, std::size_t size,
                                 ByteView data, UsbCallback done);
    void startControl(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done);
    void timeOut(UsbTransferId id);
    UsbCallback ender(UsbTransferId id);
    void transferEnded(UsbTransferId id, const UsbCompletion& completion);
    UsbStatus statusFor(const Pending& pending, UsbStatus status) const;
    void refuse(UsbCallback done, UsbStatus status);

    void watch(std::optional<bool> there);
    void tellPresence(bool present);
    void post(std::function<void()> callback);

    Scheduler& scheduler_;
    const UsbipAddress address_;
    const UsbMatch match_;
    const UsbipConnect connect_;

    State state_ = State::Closed;
    std::function<void(Result<UsbDeviceInfo>)> opened_;
    std::vector<std::function<void()>> closers_;
    std::function<void(bool)> presence_;
    std::unordered_map<UsbTransferId, Pending> pending_;
    UsbTransferId lastId_ = 0;
    TimerId timer_ = 0;  ///< While opening its deadline, while closing that.
    TimerId retry_ = 0;
    std::optional<TimePoint> released_;
    std::string lostBecause_;
    /// While the link opens: what an opening before it asked for is void.
    std::shared_ptr<const bool> opening_;
    usbip::Speed speed_ = usbip::Speed::Unknown;
    std::vector<UsbEndpointInfo> endpoints_;
    UsbipPresence watcher_;
    std::unique_ptr<UsbipClient> client_;
    std::unique_ptr<UsbipSetup> setup_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

UsbipLink::UsbipLink(Scheduler& scheduler, const UsbipAddress& address, UsbMatch match, UsbipConnect connect)
    : scheduler_(scheduler),
      address_(address),
      match_(std::move(match)),
      connect_(std::move(connect)),
      watcher_(scheduler_, address_, match_, connect_, [this] { tellPresence(true); }) {}

UsbipLink::~UsbipLink() {
    scheduler_.cancel(timer_);
    scheduler_.cancel(retry_);
    for (const auto& [id, pending] : pending_)
        scheduler_.cancel(pending.deadline);
}

void UsbipLink::post(std::function<void()> callback) {
    scheduler_.post([alive = std::weak_ptr(alive_), callback = std::move(callback)] {
        if (!alive.expired()) callback();
    });
}

// ---- Opening and closing ----

void UsbipLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    if (state_ != State::Closed)
        return post([done = std::move(done)] { done(fail(Errc::BadArgument, "link", "already open")); });
    state_ = State::Opening;
    opened_ = std::move(done);
    watcher_.stop();
    timer_ = scheduler_.callAfter(kConnectDeadline + kSetupDeadline,
                                  [this] { openEnded(fail(Errc::Io, {}, "the device does not answer")); });
    attempt();
}

void UsbipLink::attempt() {
    opening_ = std::make_shared<const bool>(true);
    connect_([this, observed = std::weak_ptr(opening_)](Result<std::unique_ptr<ByteStream>> stream) {
        if (!observed.expired()) connected(std::move(stream));
    });
}

void UsbipLink::connected(Result<std::unique_ptr<ByteStream>> stream) {
    if (!stream) return openEnded(fail(std::move(stream.error())));
    client_ = std::make_unique<UsbipClient>(scheduler_, std::move(*stream));
    client_->import(
        address_.busId, [this](const Result<usbip::Device>& device) { imported(device); },
        [this](const Error& why) { lost(why); });
}

void UsbipLink::imported(const Result<usbip::Device>& device) {
    if (!device) {
        const bool justReleased = released_ && scheduler_.now() - *released_ < kReleaseTime;
        if (device.error().code != Errc::ClaimedElsewhere || !justReleased)
            return openEnded(fail(device.error()));
        client_.reset();
        retry_ = scheduler_.callAfter(kBusyRetry, [this] { attempt(); });
        return;
    }
    speed_ = device->speed;
    setup_ =
        std::make_unique<UsbipSetup>(*client_, match_, toString(address_),
                                     [this](Result<UsbipDevice> opened) { openEnded(std::move(opened)); });
}

void UsbipLink::openEnded(Result<UsbipDevice> opened) {
    scheduler_.cancel(timer_);
    scheduler_.cancel(retry_);
    opening_.reset();
    setup_.reset();
    const auto done = std::exchange(opened_, nullptr);
    if (!opened) {
        Error error = std::move(opened.error());
        error.subject = toString(address_);
        // Nobody there, as far as anybody can tell.
        if (error.code == Errc::TimedOut) error.code = Errc::NoDevice;
        if (std::exchange(client_, nullptr)) released_ = scheduler_.now();
        state_ = State::Closed;
        watch(error.code != Errc::NoDevice && error.code != Errc::Disconnected);
        return done(fail(std::move(error)));
    }
    state_ = State::Open;
    endpoints_ = std::move(opened->endpoints);
    done(std::move(opened->info));
}

void UsbipLink::close(std::function<void()> done) {
    if (!done) done = [] {};
    if (state_ == State::Closed) return post(std::move(done));
    closers_.push_back(std::move(done));
    if (state_ == State::Closing || state_ == State::Losing) return;  // On its way already.
    scheduler_.cancel(timer_);
    scheduler_.cancel(retry_);
    const bool wasOpening = std::exchange(state_, State::Closing) == State::Opening;
    if (wasOpening) {
        opening_.reset();
        setup_.reset();
        client_.reset();
        post([opened = std::exchange(opened_, nullptr)] { opened(fail(Errc::Cancelled, "link")); });
    }
    // Whether it is there is not known to one that was about to find out.
    const auto there = wasOpening ? std::nullopt : std::optional(true);
    if (pending_.empty()) return post([this, there] { shut(there); });
    for (const auto& [id, pending] : pending_)
        client_->unlink(pending.sequence);
    timer_ = scheduler_.callAfter(kCloseDeadline, [this] { forceClose(); });
}

void UsbipLink::forceClose() {
    client_.reset();
    const std::weak_ptr alive(alive_);
    std::vector<UsbTransferId> ids;
    for (const auto& [id, pending] : pending_)
        ids.push_back(id);
    std::sort(ids.begin(), ids.end());
    for (const UsbTransferId id : ids) {
        transferEnded(id, {.status = UsbStatus::Cancelled});
        if (alive.expired()) return;
    }
}

void UsbipLink::shut(std::optional<bool> there) {
    scheduler_.cancel(timer_);
    client_.reset();
    endpoints_.clear();
    released_ = scheduler_.now();
    const bool wasLost = state_ == State::Losing;
    state_ = State::Closed;
    watch(there);
    const std::weak_ptr alive(alive_);
    for (const auto& closed : std::exchange(closers_, {})) {
        closed();
        if (alive.expired()) return;
    }
    if (wasLost) tellPresence(false);
}

UsbLinkHealth UsbipLink::health() const {
    return {.roundTrip = client_ ? client_->roundTrip() : std::nullopt, .lostBecause = lostBecause_};
}

void UsbipLink::lost(const Error& why) {
    lostBecause_ = why.detail.empty() ? "the connection to the server ended" : why.detail;
    if (state_ == State::Opening) return openEnded(fail(Errc::Disconnected));
    if (state_ == State::Open) state_ = State::Losing;
    if (state_ == State::Losing) shut(false);
}

// ---- Transfers ----

const UsbEndpointInfo* UsbipLink::find(std::uint8_t endpoint) const {
    const auto found =
        std::find_if(endpoints_.begin(), endpoints_.end(),
                     [endpoint](const UsbEndpointInfo& info) { return info.address == endpoint; });
    return found == endpoints_.end() ? nullptr : &*found;
}

Result<UsbTransferId> UsbipLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    return submit(endpoint, UsbDirection::Out, data.size(), data, std::move(done));
}

Result<UsbTransferId> UsbipLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    return submit(endpoint, UsbDirection::In, size, {}, std::move(done));
}

Result<UsbTransferId> UsbipLink::submit(std::uint8_t endpoint, UsbDirection direction, std::size_t size,
                                        ByteView data, UsbCallback done) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    if (const auto allowed = checkUsbPacket(endpoints_, endpoint, direction, size); !allowed)
        return fail(allowed.error());
    const UsbTransferId id = ++lastId_;
    const std::uint32_t interval = intervalOf(*find(endpoint), speed_);
    Pending& pending = pending_[id];
    pending.done = std::move(done);
    pending.sequence = direction == UsbDirection::Out ? client_->out(endpoint, data, interval, ender(id))
                                                      : client_->in(endpoint, size, interval, ender(id));
    return id;
}

void UsbipLink::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    if (state_ != State::Open) return refuse(std::move(done), UsbStatus::NoDevice);
    if (!setup.isIn() && data.size() != setup.length) return refuse(std::move(done), UsbStatus::Failed);
    startControl(setup, setup.isIn() ? ByteView() : data, deadline, std::move(done));
}

void UsbipLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    if (state_ != State::Open) return refuse(std::move(done), UsbStatus::NoDevice);
    if (!find(endpoint)) return refuse(std::move(done), UsbStatus::Failed);
    UsbSetup setup;
    setup.requestType = kToEndpoint;
    setup.request = kClearFeature;
    setup.index = endpoint;
    startControl(setup, {}, kClearHaltDeadline, std::move(done));
}

void UsbipLink::startControl(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    const UsbTransferId id = ++lastId_;
    Pending& pending = pending_[id];
    pending.done = std::move(done);
    pending.sequence = client_->control(setup, data, ender(id));
    pending.deadline = scheduler_.callAfter(deadline, [this, id] { timeOut(id); });
}

void UsbipLink::timeOut(UsbTransferId id) {
    const auto found = pending_.find(id);
    if (found == pending_.end()) return;
    found->second.timedOut = true;
    cancel(id);
}

void UsbipLink::cancel(UsbTransferId id) {
    const auto found = pending_.find(id);
    if (found != pending_.end() && client_) client_->unlink(found->second.sequence);
}

UsbCallback UsbipLink::ender(UsbTransferId id) {
    return [this, id](const UsbCompletion& completion) { transferEnded(id, completion); };
}

void UsbipLink::transferEnded(UsbTransferId id, const UsbCompletion& completion) {
    const Pending pending = std::move(pending_.extract(id).mapped());
    scheduler_.cancel(pending.deadline);
    if (completion.status == UsbStatus::NoDevice && state_ == State::Open) state_ = State::Losing;
    const UsbStatus status = statusFor(pending, completion.status);
    const bool moved = status == UsbStatus::Completed;
    const std::weak_ptr alive(alive_);
    if (pending.done) {
        pending.done(
            {.status = status, .data = moved ? completion.data : ByteView(), .actual = completion.actual});
    }
    if (alive.expired() || state_ != State::Closing || !pending_.empty()) return;
    // Not here, inside the client's own callback.
    scheduler_.cancel(timer_);
    post([this] { shut(true); });
}

UsbStatus UsbipLink::statusFor(const Pending& pending, UsbStatus status) const {
    if (status == UsbStatus::Completed) return status;
    // However the server ended it, the reason was that the link closes, or that the device is gone.
    if (state_ == State::Closing) return UsbStatus::Cancelled;
    if (state_ == State::Losing) return UsbStatus::NoDevice;
    return status == UsbStatus::Cancelled && pending.timedOut ? UsbStatus::TimedOut : status;
}

void UsbipLink::refuse(UsbCallback done, UsbStatus status) {
    if (!done) return;
    post([done = std::move(done), status] { done({.status = status}); });
}

// ---- Coming and going ----

void UsbipLink::setPresenceListener(std::function<void(bool present)> listener) {
    const bool watched = presence_ != nullptr;
    presence_ = std::move(listener);
    if (!presence_) return watcher_.stop();
    if (!watched && state_ == State::Closed) watcher_.start(std::nullopt);
}

void UsbipLink::watch(std::optional<bool> there) {
    if (presence_) watcher_.start(there);
}

void UsbipLink::tellPresence(bool present) {
    // A copy, because the listener may destroy this link.
    if (const auto listener = presence_) listener(present);
}

}  // namespace

std::unique_ptr<UsbLink> makeUsbipLink(Scheduler& scheduler, const UsbipAddress& address, UsbMatch match) {
    // Shared with the connector alone, so that the sockets go with the link, after its streams.
    auto sockets = std::make_shared<Sockets>(scheduler);
    return makeUsbipLink(
        scheduler, address, std::move(match), [sockets = std::move(sockets), address](auto done) {
            sockets->connectTcp(address.host, address.port, kConnectDeadline, std::move(done));
        });
}

std::unique_ptr<UsbLink> makeUsbipLink(Scheduler& scheduler, const UsbipAddress& address, UsbMatch match,
                                       UsbipConnect connect) {
    return std::make_unique<UsbipLink>(scheduler, address, std::move(match), std::move(connect));
}

}  // namespace kickstand
