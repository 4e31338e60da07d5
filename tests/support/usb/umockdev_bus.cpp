#include "tests/support/usb/umockdev_bus.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <future>

#include "tests/support/usb/usbfs_device.h"

namespace kickstand::testing {
namespace {

/// A file that nobody may open for writing, root included.
constexpr const char* kForbidden = "/proc/sys/kernel/ostype";

/// A number with leading zeros.
std::string padded(unsigned value, unsigned base, std::size_t width) {
    std::string text;
    for (; value != 0 || text.size() < width; value /= base)
        text.insert(text.begin(), "0123456789ABCDEF"[value % base]);
    return text;
}

std::string hex(ByteView bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes)
        text += padded(byte, 16, 2);
    return text;
}

/// A device's node, as programs know it.
std::string nodeOf(unsigned number) {
    return "/dev/bus/usb/001/" + padded(number, 10, 3);
}

}  // namespace

/// One port and the model that is connected with it. On the model's thread.
class UmockdevBus::Port final : private UsbDeviceListener {
  public:
    Port(UmockdevBus& bus, UsbDeviceModel& model, std::string place, Permission permission)
        : bus_(bus), model_(model), place_(std::move(place)), permission_(permission) {
        model_.setListener(this);
        if (model_.attached()) plug();
    }
    ~Port() override {
        model_.setListener(nullptr);
        if (device_) unplug();
    }
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;

  private:
    void endpointReady(std::uint8_t endpoint) override {
        if (device_) device_->endpointReady(endpoint);
    }
    void attachedChanged(bool attached) override {
        if (attached && !device_) plug();
        if (!attached && device_) unplug();
    }

    void plug();
    void unplug();
    void listen();
    void announce();

    UmockdevBus& bus_;
    UsbDeviceModel& model_;
    const std::string place_;
    const Permission permission_;
    std::shared_ptr<UsbfsDevice> device_;
    unsigned number_ = 0;
    std::string node_;     ///< As programs know it: "/dev/bus/usb/001/002".
    std::string syspath_;  ///< "/sys/devices/usb1/1-1".
};

void UmockdevBus::Port::plug() {
    namespace fs = std::filesystem;
    bus_.addHubsBefore(place_);
    number_ = ++bus_.lastNumber_;
    node_ = nodeOf(number_);
    syspath_ = "/sys/devices/usb1/" + place_;
    fs::create_directories(bus_.root_ + "/dev/bus/usb/001");
    // The kernel has configured a device before anybody hears of it.
    UsbSetup setup;
    setup.request = 9;
    setup.value = 1;
    std::vector<std::uint8_t> unused;
    model_.control(setup, {}, unused);
    const std::string realNode = bus_.root_ + node_;
    const bool denied = permission_ == Permission::Denied;
    device_ = std::make_shared<UsbfsDevice>(
        bus_.scheduler_, model_, denied ? realNode + ".unused" : realNode, [this](std::uint8_t value) {
            const std::string shown = value == 0 ? "" : std::to_string(value) + "\n";
            umockdev_testbed_set_attribute(bus_.testbed_.get(), syspath_.c_str(), "bConfigurationValue",
                                           shown.c_str());
        });
    if (denied) fs::create_symlink(kForbidden, realNode);
    // Programs open a device as soon as they hear of it, so that it must answer before.
    listen();
    announce();
}

void UmockdevBus::Port::listen() {
    using Held = std::shared_ptr<UsbfsDevice>;
    const std::unique_ptr<UMockdevIoctlBase, Unref> handler(umockdev_ioctl_base_new());
    const auto handle = +[](UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer device) -> gboolean {
        (*static_cast<Held*>(device))->answer(client);
        return TRUE;
    };
    const auto release = +[](gpointer device, GClosure*) { delete static_cast<Held*>(device); };
    g_signal_connect_data(handler.get(), "handle-ioctl", G_CALLBACK(handle), new Held(device_), release,
                          GConnectFlags(0));
    umockdev_testbed_attach_ioctl(bus_.testbed_.get(), node_.c_str(), handler.get(), nullptr);
}

void UmockdevBus::Port::announce() {
    const UsbDescriptors& descriptors = model_.descriptors();
    std::vector<std::uint8_t> bytes = descriptors.device;
    bytes.insert(bytes.end(), descriptors.configuration.begin(), descriptors.configuration.end());
    bus_.add(place_, number_, bytes);
}

/// Hubs are there for their place alone: nobody opens one.
void UmockdevBus::addHubsBefore(const std::string& place) {
    static constexpr std::array<std::uint8_t, 18> kHub{18,   1,    0,    2, 9, 0, 0, 64, 0x6B,
                                                       0x1D, 0x02, 0x00, 0, 1, 0, 0, 0,  0};
    for (std::size_t dot = place.find('.'); dot != std::string::npos; dot = place.find('.', dot + 1)) {
        const std::string hub = place.substr(0, dot);
        if (hubs_.insert(hub).second) add(hub, ++lastNumber_, kHub);
    }
}

void UmockdevBus::add(const std::string& place, unsigned number, ByteView descriptors) {
    std::string record = "P: /devices/usb1/" + place + "\n";
    const auto property = [&](const std::string& key, const std::string& value) {
        record += "E: " + key + "=" + value + "\n";
    };
    const auto attribute = [&](const std::string& key, const std::string& value) {
        record += "A: " + key + "=" + value + "\\n\n";
    };
    property("SUBSYSTEM", "usb");
    property("DEVTYPE", "usb_device");
    property("BUSNUM", "001");
    property("DEVNUM", padded(number, 10, 3));
    property("DEVNAME", nodeOf(number));
    attribute("busnum", "1");
    attribute("devnum", std::to_string(number));
    attribute("speed", "12");
    attribute("bConfigurationValue", "1");
    record += "H: descriptors=" + hex(descriptors) + "\n";
    GError* error = nullptr;
    if (!umockdev_testbed_add_from_string(testbed_.get(), record.c_str(), &error)) {
        std::fprintf(stderr, "umockdev does not take the device: %s\n", error->message);
        g_error_free(error);
    }
}

void UmockdevBus::Port::unplug() {
    UMockdevTestbed* testbed = bus_.testbed_.get();
    device_->hangUp();
    device_.reset();
    umockdev_testbed_uevent(testbed, syspath_.c_str(), "remove");
    // The ioctls stay attached: a program may just have opened the node, and gets its answer, which is that
    // the device is gone.
    umockdev_testbed_remove_device(testbed, syspath_.c_str());
    std::filesystem::remove(bus_.root_ + node_);
    std::filesystem::remove(bus_.root_ + node_ + ".unused");
}

UmockdevBus::UmockdevBus(Scheduler& scheduler) : scheduler_(scheduler), testbed_(umockdev_testbed_new()) {
    const std::unique_ptr<char, decltype(&g_free)> root(umockdev_testbed_get_root_dir(testbed_.get()),
                                                        &g_free);
    root_ = root.get();
    // The preload would otherwise connect every file below /dev with the test bed, and give up after fifty.
    std::filesystem::remove(root_ + "/ioctl/_default");
}

UmockdevBus::~UmockdevBus() {
    onModels([this] { ports_.clear(); });
}

void UmockdevBus::connect(UsbDeviceModel& model, const std::string& port, Permission permission) {
    onModels([&] { ports_[port] = std::make_unique<Port>(*this, model, port, permission); });
}

void UmockdevBus::disconnect(const std::string& port) {
    onModels([&] { ports_.erase(port); });
}

void UmockdevBus::onModels(const std::function<void()>& action) {
    // Shared, because this side may return while the other still is in set_value().
    const auto done = std::make_shared<std::promise<void>>();
    scheduler_.post([&action, done] {
        action();
        done->set_value();
    });
    done->get_future().wait();
}

}  // namespace kickstand::testing
