#pragma once

#include <cstdint>
#include <string_view>

namespace kickstand::rules {

/// Where a file stands among the layers.
enum class Layer : std::uint8_t {
    Other,
    App,
    Ui,
    UiTraffic,  ///< The traffic inspector, which may see every wire/.
    Engine,
    System,  ///< core/<system>: model and controller.
    Wire,    ///< core/<system>/wire.
    Image,   ///< core/<system>/image: firmware files.
    Sim,     ///< core/<system>/sim.
    Beside,  ///< capture, telemetry, ledger: beside the systems.
    UsbIp,
    Link,
    Framing,
    Base,
    Tests,
};

/// A layer, and the folder of core/ that it is in: two systems are the same layer and may not see each other.
struct Place {
    Layer layer = Layer::Other;
    std::string_view folder;

    friend bool operator==(const Place&, const Place&) = default;
};

/// Where a path from the root stands. A folder of core/ that is none of the shared ones is a system, so that
/// a new system needs no change here. The result refers into `path`.
Place placeOf(std::string_view path);

/// Whether a file at `from` may include the header `header`, both as paths from the root.
bool mayInclude(std::string_view from, std::string_view header);

/// What the layer of `from` may include, in words.
std::string_view allowanceOf(std::string_view from);

}  // namespace kickstand::rules
