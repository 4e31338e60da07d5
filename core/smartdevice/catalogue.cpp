#include "core/smartdevice/catalogue.h"

#include <algorithm>

namespace kickstand::smartdevice {
namespace {

wire::ParameterMask maskOf(const DeviceSpec& device, bool (ParameterSpec::*holds)() const) {
    wire::ParameterMask mask = 0;
    for (std::size_t i = 0; i < device.parameters.size(); ++i) {
        if ((device.parameters[i].*holds)()) mask = static_cast<wire::ParameterMask>(mask | 1U << i);
    }
    return mask;
}

}  // namespace

int DeviceSpec::find(std::string_view parameter) const {
    const auto found = std::ranges::find(parameters, parameter, &ParameterSpec::name);
    return found == parameters.end() ? -1 : static_cast<int>(found - parameters.begin());
}

wire::ParameterMask DeviceSpec::readable() const {
    return maskOf(*this, &ParameterSpec::readable);
}

wire::ParameterMask DeviceSpec::writable() const {
    return maskOf(*this, &ParameterSpec::writable);
}

SharedDeviceSpec Catalogue::find(std::uint16_t id) const {
    const auto found =
        std::ranges::find_if(devices_, [id](const SharedDeviceSpec& device) { return device->id == id; });
    return found == devices_.end() ? nullptr : *found;
}

SharedDeviceSpec Catalogue::find(std::string_view name) const {
    const auto found = std::ranges::find_if(
        devices_, [name](const SharedDeviceSpec& device) { return device->name == name; });
    return found == devices_.end() ? nullptr : *found;
}

void Catalogue::put(DeviceSpec device) {
    const auto place = std::ranges::lower_bound(devices_, device.id, {},
                                                [](const SharedDeviceSpec& one) { return one->id; });
    const bool same = place != devices_.end() && (*place)->id == device.id;
    auto shared = std::make_shared<const DeviceSpec>(std::move(device));
    if (same)
        *place = std::move(shared);
    else
        devices_.insert(place, std::move(shared));
}

Result<Catalogue> makeCatalogue(std::string_view userText, const std::string& source) {
    auto builtIn = readCatalogue(builtInCatalogueText(), "devices.json");
    if (!builtIn || userText.empty()) return builtIn;
    return readCatalogue(userText, source, std::move(*builtIn));
}

}  // namespace kickstand::smartdevice
