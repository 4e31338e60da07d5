#include "core/smartdevice/events.h"

namespace kickstand::smartdevice {

std::string_view name(EventKind kind) noexcept {
    switch (kind) {
        case EventKind::PortFound:
            return "port-found";
        case EventKind::PortGone:
            return "port-gone";
        case EventKind::PortFailed:
            return "port-failed";
        case EventKind::PortSilent:
            return "port-silent";
        case EventKind::DeviceFound:
            return "device-found";
        case EventKind::DeviceBack:
            return "device-back";
        case EventKind::DeviceQuiet:
            return "device-quiet";
        case EventKind::DeviceLost:
            return "device-lost";
        case EventKind::DeviceReset:
            return "device-reset";
        case EventKind::Subscribed:
            return "subscribed";
        case EventKind::Ungranted:
            return "ungranted";
        case EventKind::Update:
            return "update";
        case EventKind::WriteRefused:
            return "write-refused";
        case EventKind::WriteChanged:
            return "write-changed";
        case EventKind::Disabled:
            return "disabled";
        case EventKind::DeviceError:
            return "device-error";
        case EventKind::Misfit:
            return "misfit";
        case EventKind::Stopped:
            return "stopped";
        case EventKind::CatalogueBad:
            return "catalogue-bad";
    }
    return "";
}

}  // namespace kickstand::smartdevice
