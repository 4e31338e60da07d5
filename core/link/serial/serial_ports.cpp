#include "core/link/serial/serial_ports.h"

#include <QFileInfo>
#include <QSerialPortInfo>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/link/serial/serial_byte_link.h"
#include "core/link/serial/serial_port.h"

namespace kickstand {
namespace {

constexpr std::chrono::milliseconds kLookEvery(500);

BytePort describe(const QSerialPortInfo& info) {
    BytePort port;
    port.name = info.systemLocation().toStdString();
    port.description = info.description().toStdString();
    port.manufacturer = info.manufacturer().toStdString();
    port.serialNumber = info.serialNumber().toStdString();
    port.vendor = info.hasVendorIdentifier() ? info.vendorIdentifier() : 0;
    port.product = info.hasProductIdentifier() ? info.productIdentifier() : 0;
    return port;
}

std::vector<BytePort> lookForUsb() {
    std::vector<BytePort> found = listSerialPorts();
    std::erase_if(found, [](const BytePort& port) { return port.vendor == 0; });
    return found;
}

std::vector<BytePort> lookForOne(const std::string& name) {
    if (!serial::portExists(name)) return {};
    // The system's list knows neither pseudo-terminals nor symbolic links.
    const QString listed = QFileInfo(QFileInfo(QString::fromStdString(name)).canonicalFilePath()).fileName();
    BytePort port = describe(QSerialPortInfo(listed.isEmpty() ? QString::fromStdString(name) : listed));
    port.name = name;
    return {port};
}

class SerialPorts final : public BytePorts {
  public:
    SerialPorts(Scheduler& scheduler, std::string only) : scheduler_(scheduler), only_(std::move(only)) {}

    ~SerialPorts() override {
        alive_.reset();
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
        }
        wake_.notify_all();
        if (thread_.joinable()) thread_.join();
    }
    SerialPorts(const SerialPorts&) = delete;
    SerialPorts& operator=(const SerialPorts&) = delete;

    void watch(std::function<void(const std::vector<BytePort>&)> changed) override {
        changed_ = std::move(changed);
        if (!changed_) return;
        if (told_) tellLater();
        if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
    }

    std::unique_ptr<ByteLink> makeLink(const std::string& name, Baud baud) override {
        return makeSerialByteLink(scheduler_, name, baud);
    }

  private:
    void run() {
        std::optional<std::vector<BytePort>> last;
        std::unique_lock lock(mutex_);
        while (!ending_) {
            lock.unlock();
            auto found = only_.empty() ? lookForUsb() : lookForOne(only_);
            if (found != last) {
                last = found;
                scheduler_.post([this, alive = observedAlive_, found = std::move(found)]() mutable {
                    if (alive.expired()) return;
                    told_ = std::move(found);
                    tell();
                });
            }
            lock.lock();
            wake_.wait_for(lock, kLookEvery, [this] { return ending_; });
        }
    }

    void tellLater() {
        scheduler_.post([this, alive = observedAlive_] {
            if (!alive.expired()) tell();
        });
    }

    void tell() {
        // Copies, because the listener may end the watch or destroy this.
        const auto ports = *told_;
        if (const auto changed = changed_) changed(ports);
    }

    Scheduler& scheduler_;
    const std::string only_;
    std::function<void(const std::vector<BytePort>&)> changed_;
    std::optional<std::vector<BytePort>> told_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
    const std::weak_ptr<const bool> observedAlive_ = alive_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace

std::vector<BytePort> listSerialPorts() {
    std::vector<BytePort> found;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts())
        found.push_back(describe(info));
    std::ranges::sort(found, {}, [](const BytePort& port) { return std::pair(port.vendor == 0, port.name); });
    return found;
}

std::unique_ptr<BytePorts> makeSerialPorts(Scheduler& scheduler, std::string only) {
    return std::make_unique<SerialPorts>(scheduler, std::move(only));
}

}  // namespace kickstand
