#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/engine/link_provider.h"
#include "tests/ui/wire_log.h"

namespace kickstand::test {

/// What the links of a test share with the test.
struct LinkBoard {
    WireLog wire;
    std::mutex mutex;
    FoundHardware found;              ///< What discovery finds.
    std::vector<std::string> opened;  ///< The URIs that links were made for.

    void setFound(std::vector<FoundDevice> devices, std::vector<BytePort> ports = {});
    std::vector<std::string> openedLinks();
};

/// Simulated devices behind a log of the wire, for every URI: to the window, `usb:` is hardware.
std::unique_ptr<LinkProvider> makeTestLinks(std::shared_ptr<LinkBoard> board);

}  // namespace kickstand::test
