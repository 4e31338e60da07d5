#pragma once

#include "core/base/time.h"
#include "core/link/usb_types.h"

namespace kickstand {

/// One thing that happened on a USB link, as seen from the host. Plain facts: a model fed with records cannot
/// tell a live link from a replayed one. `data` is valid only during the call that hands the record over.
struct UsbTapRecord {
    enum class Kind : std::uint8_t {
        Opened,     ///< Configured and claimed; nothing an earlier program left behind remains.
        Closed,     ///< Closed by this program.
        Lost,       ///< Gone: unplugged, or the other machine is.
        Submitted,  ///< An OUT packet or control transfer was handed to the host controller.
        Completed,  ///< A transfer ended, with its status; for IN with its bytes.
    };

    Kind kind = Kind::Completed;
    TimePoint time{};
    std::uint8_t endpoint = 0;        ///< With the direction bit; 0 for control transfers.
    std::optional<UsbSetup> setup{};  ///< For control transfers.
    UsbStatus status = UsbStatus::Completed;
    std::size_t actual = 0;  ///< Bytes that really moved.
    ByteView data{};         ///< OUT: the bytes sent (in both records); IN: the bytes received.
    UsbTransferId id = 0;    ///< Joins Submitted and Completed; 0 where there is nothing to join.
};

/// Watches a link. Called on the link's thread; what it needs later it copies.
class UsbTapObserver {
  public:
    virtual ~UsbTapObserver() = default;
    /// One transfer has begun or ended. The link's thread; the bytes are valid during the call.
    virtual void observe(const UsbTapRecord& record) = 0;
};

}  // namespace kickstand
