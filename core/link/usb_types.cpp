#include "core/link/usb_types.h"

namespace kickstand {

const char* name(UsbStatus status) {
    switch (status) {
        case UsbStatus::Completed:
            return "completed";
        case UsbStatus::Stalled:
            return "stalled";
        case UsbStatus::TimedOut:
            return "timed-out";
        case UsbStatus::Cancelled:
            return "cancelled";
        case UsbStatus::NoDevice:
            return "no-device";
        case UsbStatus::Overflow:
            return "overflow";
        case UsbStatus::Failed:
            return "failed";
    }
    return "unknown";
}

}  // namespace kickstand
