#include "core/link/socket/io_core.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <asio/error.hpp>

namespace kickstand::socket {
namespace {

/// One of the system's numbers and what it means here.
struct Meaning {
    int number;
    Errc code;
};
constexpr std::array kMeanings{
    Meaning{asio::error::connection_refused, Errc::NoDevice},
    Meaning{asio::error::host_unreachable, Errc::NoDevice},
    Meaning{asio::error::network_unreachable, Errc::NoDevice},
    Meaning{ENOENT, Errc::NoDevice},
    Meaning{asio::error::access_denied, Errc::PermissionDenied},
    Meaning{asio::error::no_permission, Errc::PermissionDenied},
    Meaning{asio::error::address_in_use, Errc::ClaimedElsewhere},
    Meaning{asio::error::timed_out, Errc::TimedOut},
    Meaning{asio::error::connection_reset, Errc::Disconnected},
    Meaning{asio::error::broken_pipe, Errc::Disconnected},
    Meaning{asio::error::not_connected, Errc::Disconnected},
};

Errc codeOf(const std::error_code& code) {
    if (code == asio::error::eof) return Errc::Disconnected;
    // Asio and the standard library each have a category for the system's numbers, and neither compares to
    // the other.
    if (code.category() != asio::error::get_system_category() && code.category() != std::system_category())
        return Errc::Io;
    const auto found = std::find_if(kMeanings.begin(), kMeanings.end(),
                                    [&](const Meaning& meaning) { return meaning.number == code.value(); });
    return found == kMeanings.end() ? Errc::Io : found->code;
}

}  // namespace

Error toError(const std::error_code& code, std::string subject) {
    Error error;
    error.code = codeOf(code);
    error.subject = std::move(subject);
    error.detail = code.message();
    return error;
}

}  // namespace kickstand::socket
