#include "core/thunderbots/image/image_error.h"

#include <array>

namespace kickstand::thunderbots::image {

const char* name(ImageFault fault) {
    constexpr std::array kNames{"too-large",    "empty",        "junk",       "bad-length",
                                "bad-checksum", "unknown-type", "overlap",    "missing-end",
                                "after-end",    "past-end",     "bad-header", "looks-like-other"};
    const auto at = static_cast<std::size_t>(fault);
    return at < kNames.size() ? kNames[at] : "unknown";
}

Error toError(const ImageError& error, std::string file) {
    Error made;
    made.code = Errc::Malformed;
    made.subject = std::move(file);
    made.detail = name(error.fault);
    if (error.line != 0) made.detail += ", line " + std::to_string(error.line);
    if (error.fault == ImageFault::PastEnd || error.fault == ImageFault::Overlap)
        made.detail += ", address " + std::to_string(error.address);
    return made;
}

}  // namespace kickstand::thunderbots::image
