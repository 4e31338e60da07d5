#include "ui/smartdevice/device_choice.h"

#include <QSettings>

#include "core/engine/describe_smartdevice.h"

namespace kickstand::ui {

using smartdevice::DeviceState;
using smartdevice::Snapshot;

namespace {

constexpr QLatin1String kSimulatedPort("simulated-");
constexpr int kLongestName = 64;

}  // namespace

void DeviceChoice::choose(int device) {
    if (device == chosen_) return;
    chosen_ = device;
    emit changed();
}

void DeviceChoice::follow(const Snapshot* snapshot) {
    units_.clear();
    kinds_.clear();
    if (snapshot == nullptr) return choose(-1);
    for (const DeviceState& device : snapshot->devices) {
        const QString port = QString::fromStdString(device.port);
        if (!port.startsWith(kSimulatedPort)) continue;
        const int unit = port.mid(kSimulatedPort.size()).toInt();
        units_[device.number] = unit;
        kinds_[unit] = QString::fromStdString(device.spec->name);
    }
    if (deviceOf(snapshot) == nullptr) choose(snapshot->devices.empty() ? -1 : 0);
}

const DeviceState* DeviceChoice::deviceOf(const Snapshot* snapshot) const {
    const auto at = static_cast<std::size_t>(chosen_);
    const bool there = snapshot != nullptr && chosen_ >= 0 && at < snapshot->devices.size();
    return there ? &snapshot->devices[at] : nullptr;
}

int DeviceChoice::chosenUnit() const {
    const auto found = units_.find(chosen_);
    return found == units_.end() ? -1 : found->second;
}

QString DeviceChoice::kindOfUnit(int unit) const {
    const auto found = kinds_.find(unit);
    return found == kinds_.end() ? QString() : found->second;
}

QString ownNameOf(const QSettings& settings, const DeviceState& device) {
    return settings.value(ownNameKey(device.uid)).toString();
}

void setOwnName(QSettings& settings, const DeviceState& device, const QString& name) {
    const QString kept = name.simplified().left(kLongestName);
    if (kept.isEmpty())
        settings.remove(ownNameKey(device.uid));
    else
        settings.setValue(ownNameKey(device.uid), kept);
}

QString titleOf(const QSettings& settings, const DeviceState& device) {
    const QString own = ownNameOf(settings, device);
    return own.isEmpty() ? QString::fromStdString(device.spec->name) : own;
}

}  // namespace kickstand::ui
