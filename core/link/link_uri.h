#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace kickstand {

/// A link as a person writes it: `usb:?port=1-2.3`, `sim:thunderbots?robots=0-15&loss=0.02`,
/// `usbip:127.0.0.1:3240/1-1`, `serial:/dev/ttyACM0?baud=115200`.
struct LinkUri {
    std::string scheme;  ///< Lower case: "usb", "usb-cable", "sim", "usbip", "serial", "replay".
    std::string target;  ///< What stands between the colon and the question mark.
    std::map<std::string, std::string> options;  ///< Decoded key=value pairs; keys are unique.

    bool isSimulated() const { return scheme == "sim"; }
    friend bool operator==(const LinkUri&, const LinkUri&) = default;
};

/// Takes a URI apart. Errors: BadUri, naming the piece that could not be read. Schemes and options are judged
/// by whoever opens the link, who knows what it takes. Any thread.
Result<LinkUri> parseLinkUri(std::string_view text);

/// The text that parses to `uri`. Any thread.
std::string toString(const LinkUri& uri);

}  // namespace kickstand
