#include "tests/support/usb/usbfs_device.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace kickstand::testing {
namespace {

constexpr std::size_t kSetupSize = 8;
constexpr int kSmallestPipe = 4096;
constexpr std::uint8_t kControl = 0;

struct Unref {
    void operator()(void* object) const { g_object_unref(object); }
};
using Memory = std::unique_ptr<UMockdevIoctlData, Unref>;

/// The program's memory at the address that lies at `offset` in `data`; empty where it cannot be had.
Memory follow(UMockdevIoctlData* data, std::size_t offset, std::size_t size) {
    return Memory(umockdev_ioctl_data_resolve(data, offset, size, nullptr));
}

/// The number that an ioctl's argument points to.
unsigned argument(UMockdevIoctlClient* client) {
    const Memory memory = follow(umockdev_ioctl_client_get_arg(client), 0, sizeof(unsigned));
    unsigned value = 0;
    if (memory) std::memcpy(&value, memory->data, sizeof value);
    return value;
}

/// The request that a program submitted; umockdev gives memory that is aligned for it.
usbdevfs_urb& urbIn(const Memory& memory) {
    return *static_cast<usbdevfs_urb*>(static_cast<void*>(memory->data));
}

/// The argument itself, for the one ioctl that takes an address and nothing behind it.
unsigned long rawArgument(UMockdevIoctlClient* client) {
    unsigned long value = 0;
    std::memcpy(&value, umockdev_ioctl_client_get_arg(client)->data, sizeof value);
    return value;
}

void complete(UMockdevIoctlClient* client, int error) {
    umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
}

}  // namespace

UsbfsNode::UsbfsNode(const std::string& path) : path_(path) {
    constexpr mode_t kOwnerOnly = 0600;
    if (mkfifo(path.c_str(), kOwnerOnly) != 0) return;
    fifo_ = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    fcntl(fifo_, F_SETPIPE_SZ, kSmallestPipe);
    setReapable(false);
}

UsbfsNode::~UsbfsNode() {
    if (fifo_ >= 0) close(fifo_);
}

void UsbfsNode::setReapable(bool reapable) {
    if (fifo_ < 0 || reapable == reapable_) return;
    reapable_ = reapable;
    std::array<char, kSmallestPipe> filling{};
    if (reapable) {
        while (::read(fifo_, filling.data(), filling.size()) > 0) {
        }
    } else {
        while (write(fifo_, filling.data(), filling.size()) > 0) {
        }
    }
}

/// One request of a program, from its submission until it was reaped.
struct UsbfsDevice::Urb {
    Owner owner = nullptr;
    Memory memory;  ///< The program's usbdevfs_urb. Written only when it is reaped.
    Memory buffer;  ///< What that points to; empty where it has no bytes.
    std::uint8_t endpoint = 0;
    bool isControl = false;
    std::vector<std::uint8_t> out;  ///< Copied at submission, the setup of a control transfer included.
    std::size_t room = 0;
    std::vector<std::uint8_t> in;
    std::size_t actual = 0;
    int status = 0;
};

UsbfsDevice::UsbfsDevice(Scheduler& scheduler, UsbDeviceModel& model, const std::string& nodePath,
                         std::function<void(std::uint8_t)> configured)
    : scheduler_(scheduler), model_(model), configured_(std::move(configured)), node_(nodePath) {}

UsbfsDevice::~UsbfsDevice() = default;

void UsbfsDevice::watch(UMockdevIoctlClient* client) {
    constexpr const char* kWatched = "kickstand-watched";
    if (g_object_get_data(G_OBJECT(client), kWatched) != nullptr) return;
    g_object_set_data(G_OBJECT(client), kWatched, client);
    const auto vanished = +[](gpointer self, GObject* gone) {
        const std::unique_ptr<std::weak_ptr<UsbfsDevice>> device(
            static_cast<std::weak_ptr<UsbfsDevice>*>(self));
        if (const auto alive = device->lock())
            alive->scheduler_.post([alive, owner = Owner(gone)] { alive->forget(owner); });
    };
    g_object_weak_ref(G_OBJECT(client), vanished, new std::weak_ptr<UsbfsDevice>(weak_from_this()));
}

void UsbfsDevice::answer(UMockdevIoctlClient* client) {
    watch(client);
    const Owner owner = client;
    switch (umockdev_ioctl_client_get_request(client)) {
        case USBDEVFS_GET_CAPABILITIES: {
            const Memory memory = follow(umockdev_ioctl_client_get_arg(client), 0, sizeof(std::uint32_t));
            const std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                               USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
            std::memcpy(memory->data, &capabilities, sizeof capabilities);
            return complete(client, 0);
        }
        case USBDEVFS_SUBMITURB:
            return submit(client);
        case USBDEVFS_REAPURB:
        case USBDEVFS_REAPURBNDELAY:
            return reap(client);
        case USBDEVFS_DISCARDURB:
            return completeOnModel(
                client, [this, owner, address = rawArgument(client)] { return discard(owner, address); });
        case USBDEVFS_CLAIMINTERFACE:
            return completeOnModel(client, [this, owner, interface = argument(client)] {
                return claim(owner, static_cast<std::uint8_t>(interface));
            });
        case USBDEVFS_RELEASEINTERFACE:
            return completeOnModel(client, [this, interface = argument(client)] {
                return claims_.erase(static_cast<std::uint8_t>(interface)) != 0 ? 0 : EINVAL;
            });
        case USBDEVFS_SETCONFIGURATION:
            return completeOnModel(client, [this, value = static_cast<int>(argument(client))] {
                return configure(static_cast<std::uint8_t>(std::max(value, 0)));
            });
        case USBDEVFS_CLEAR_HALT:
            return completeOnModel(client, [this, endpoint = argument(client)] {
                return clearHalt(static_cast<std::uint8_t>(endpoint));
            });
        case USBDEVFS_GETDRIVER:
        case USBDEVFS_IOCTL:
            return complete(client, ENODATA);
        default:
            return complete(client, ENOTTY);
    }
}

void UsbfsDevice::completeOnModel(UMockdevIoctlClient* client, std::function<int()> action) {
    g_object_ref(client);
    scheduler_.post([self = shared_from_this(), held = std::shared_ptr<UMockdevIoctlClient>(client, Unref()),
                     action = std::move(action)] { complete(held.get(), self->gone_ ? ENODEV : action()); });
}

void UsbfsDevice::submit(UMockdevIoctlClient* client) {
    auto urb = std::make_shared<Urb>();
    urb->owner = client;
    urb->memory = follow(umockdev_ioctl_client_get_arg(client), 0, sizeof(usbdevfs_urb));
    const usbdevfs_urb& given = urbIn(urb->memory);
    const auto length = static_cast<std::size_t>(std::max(given.buffer_length, 0));
    urb->buffer = follow(urb->memory.get(), offsetof(usbdevfs_urb, buffer), length);
    urb->endpoint = given.endpoint;
    urb->isControl = given.type == USBDEVFS_URB_TYPE_CONTROL;
    if (urb->buffer) urb->out.assign(urb->buffer->data, urb->buffer->data + length);
    urb->room = length;
    completeOnModel(client, [this, urb] { return take(urb); });
}

void UsbfsDevice::reap(UMockdevIoctlClient* client) {
    UrbPointer urb;
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::find_if(finished_.begin(), finished_.end(),
                                        [client](const UrbPointer& done) { return done->owner == client; });
        if (found != finished_.end()) {
            urb = *found;
            finished_.erase(found);
        }
        if (finished_.empty()) node_.setReapable(false);
    }
    if (!urb) return complete(client, EAGAIN);
    usbdevfs_urb& result = urbIn(urb->memory);
    result.status = urb->status;
    result.actual_length = static_cast<int>(urb->actual);
    if (!urb->in.empty() && urb->buffer)
        std::memcpy(urb->buffer->data + (urb->isControl ? kSetupSize : 0), urb->in.data(), urb->in.size());
    const Memory place = follow(umockdev_ioctl_client_get_arg(client), 0, sizeof(void*));
    umockdev_ioctl_data_set_ptr(place.get(), 0, urb->memory.get());
    complete(client, 0);
}

int UsbfsDevice::take(const UrbPointer& urb) {
    const bool known = std::any_of(model_.descriptors().endpoints.begin(),
                                   model_.descriptors().endpoints.end(), [&](const UsbEndpointInfo& info) {
                                       const auto claimed = claims_.find(info.interface);
                                       return info.address == urb->endpoint && claimed != claims_.end() &&
                                              claimed->second == urb->owner;
                                   });
    if (!known && !urb->isControl) return ENOENT;
    const std::uint8_t queue = urb->isControl ? kControl : urb->endpoint;
    waiting_[queue].push_back(urb);
    move(queue);
    return 0;
}

int UsbfsDevice::discard(Owner owner, unsigned long address) {
    for (auto& [endpoint, queue] : waiting_) {
        const auto found = std::find_if(queue.begin(), queue.end(), [&](const UrbPointer& urb) {
            return urb->owner == owner && urb->memory->client_addr == address;
        });
        if (found == queue.end()) continue;
        const UrbPointer urb = *found;
        queue.erase(found);
        finish(urb, -ENOENT);
        move(endpoint);
        return 0;
    }
    return EINVAL;
}

int UsbfsDevice::claim(Owner owner, std::uint8_t interface) {
    const auto& endpoints = model_.descriptors().endpoints;
    const bool known =
        std::any_of(endpoints.begin(), endpoints.end(),
                    [interface](const UsbEndpointInfo& info) { return info.interface == interface; });
    if (!known) return ENOENT;
    const auto [held, taken] = claims_.emplace(interface, owner);
    return held->second == owner ? 0 : EBUSY;
}

int UsbfsDevice::configure(std::uint8_t value) {
    // As in the kernel: whoever holds an interface keeps the device from being configured, the caller too.
    if (!claims_.empty()) return EBUSY;
    UsbSetup setup;
    setup.request = 9;
    setup.value = value;
    std::vector<std::uint8_t> unused;
    if (model_.control(setup, {}, unused) != UsbHandshake::Ack) return EPIPE;
    configured_(value);
    return 0;
}

int UsbfsDevice::clearHalt(std::uint8_t endpoint) {
    UsbSetup setup;
    setup.requestType = 2;
    setup.request = 1;
    setup.index = endpoint;
    std::vector<std::uint8_t> unused;
    return model_.control(setup, {}, unused) == UsbHandshake::Ack ? 0 : EPIPE;
}

void UsbfsDevice::forget(Owner owner) {
    std::erase_if(claims_, [owner](const auto& claim) { return claim.second == owner; });
    for (auto& [endpoint, queue] : waiting_)
        std::erase_if(queue, [owner](const UrbPointer& urb) { return urb->owner == owner; });
    const std::lock_guard lock(mutex_);
    std::erase_if(finished_, [owner](const UrbPointer& urb) { return urb->owner == owner; });
    if (finished_.empty()) node_.setReapable(false);
}

void UsbfsDevice::endpointReady(std::uint8_t endpoint) {
    move(endpoint);
}

void UsbfsDevice::hangUp() {
    gone_ = true;
    claims_.clear();
    for (auto& [endpoint, queue] : std::exchange(waiting_, {})) {
        for (const UrbPointer& urb : queue)
            finish(urb, -ESHUTDOWN);
    }
}

void UsbfsDevice::move(std::uint8_t endpoint) {
    // Taken out while the model is asked, which may end the device from inside.
    while (!gone_ && !waiting_[endpoint].empty()) {
        const UrbPointer urb = waiting_[endpoint].front();
        waiting_[endpoint].pop_front();
        if (exchange(*urb)) {
            finish(urb, urb->status);
        } else if (gone_) {
            finish(urb, -ESHUTDOWN);
        } else {
            waiting_[endpoint].push_front(urb);
            return;
        }
    }
}

/// Whether the model answered anything but Nak.
bool UsbfsDevice::exchange(Urb& urb) {
    UsbHandshake handshake = UsbHandshake::Nak;
    if (urb.isControl) {
        const ByteView setupBytes = ByteView(urb.out).first(kSetupSize);
        const UsbSetup setup{setupBytes[0], setupBytes[1], loadLe16(setupBytes, 2), loadLe16(setupBytes, 4),
                             loadLe16(setupBytes, 6)};
        const ByteView data = setup.isIn() ? ByteView() : ByteView(urb.out).subspan(kSetupSize);
        handshake = model_.control(setup, data, urb.in);
        urb.in.resize(setup.isIn() ? std::min(urb.in.size(), urb.room - kSetupSize) : 0);
        urb.actual = setup.isIn() ? urb.in.size() : data.size();
    } else if (isInEndpoint(urb.endpoint)) {
        const auto& endpoints = model_.descriptors().endpoints;
        const auto info =
            std::find_if(endpoints.begin(), endpoints.end(),
                         [&](const UsbEndpointInfo& endpoint) { return endpoint.address == urb.endpoint; });
        urb.in.resize(info->packetSize);
        handshake = model_.in(urb.endpoint, urb.in, urb.actual);
        const bool tooMuch = handshake == UsbHandshake::Ack && urb.actual > urb.room;
        if (tooMuch) urb.status = -EOVERFLOW;
        urb.in.resize(handshake == UsbHandshake::Ack && !tooMuch ? urb.actual : 0);
    } else {
        handshake = model_.out(urb.endpoint, urb.out);
        urb.actual = urb.out.size();
    }
    if (handshake == UsbHandshake::Stall) {
        urb.status = -EPIPE;
        urb.actual = 0;
    }
    return handshake != UsbHandshake::Nak;
}

void UsbfsDevice::finish(const UrbPointer& urb, int status) {
    urb->status = status;
    if (status != 0) {
        urb->in.clear();
        urb->actual = 0;
    }
    const std::lock_guard lock(mutex_);
    finished_.push_back(urb);
    node_.setReapable(true);
}

}  // namespace kickstand::testing
