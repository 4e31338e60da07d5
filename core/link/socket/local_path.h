#pragma once

#include <string>

#include <asio/local/stream_protocol.hpp>

#include "core/base/result.h"

namespace kickstand::socket {

/// Whether a local socket can have this path. Errors: BadArgument for one that is empty or has a zero in it,
/// OutOfRange with the bound for one too long. Any thread.
inline Result<void> checkLocalPath(const std::string& path) {
    if (path.empty() || path.find('\0') != std::string::npos) return fail(Errc::BadArgument, "path");
    // One byte less than there is room for: the system ends it with a zero.
    constexpr std::size_t kLongest = sizeof(asio::detail::sockaddr_un_type::sun_path) - 1;
    if (path.size() <= kLongest) return {};
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = path;
    error.lowest = 1;
    error.highest = static_cast<std::int64_t>(kLongest);
    error.got = static_cast<std::int64_t>(path.size());
    return fail(std::move(error));
}

}  // namespace kickstand::socket
