#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"

namespace kickstand {

/// One thing that happened on a serial line, as seen from the host. Plain facts: a model fed with records
/// cannot tell a live line from a replayed one. `data` is valid only during the call that hands it over.
struct ByteTapRecord {
    enum class Kind : std::uint8_t {
        Opened,
        Closed,    ///< By this program.
        Lost,      ///< Pulled out or hung up.
        Sent,      ///< Bytes were handed to the line.
        Received,  ///< Bytes came, in whatever pieces.
    };

    Kind kind = Kind::Received;
    TimePoint time{};
    ByteView data{};
};

/// Watches a serial line. Called on the link's thread; what it needs later it copies.
class ByteTapObserver {
  public:
    virtual ~ByteTapObserver() = default;
    virtual void observe(const ByteTapRecord& record) = 0;
};

}  // namespace kickstand
