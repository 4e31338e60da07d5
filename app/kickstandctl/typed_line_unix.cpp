#include <array>

#include <poll.h>
#include <unistd.h>

#include "app/kickstandctl/typed_line.h"

namespace kickstand::ctl {
namespace {

/// Nobody types a line as long as this.
constexpr std::size_t kLongest = 4096;

}  // namespace

std::optional<std::string> TypedLine::take() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (!ended_ && typed_.find('\n') == std::string::npos && ::poll(&input, 1, 0) > 0) {
        std::array<char, 256> piece{};
        const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
        if (count > 0) typed_.append(piece.data(), static_cast<std::size_t>(count));
        ended_ = count <= 0 || typed_.size() > kLongest;
    }
    const std::size_t end = typed_.find('\n');
    if (end == std::string::npos) return std::nullopt;
    std::string line = typed_.substr(0, end);
    typed_.erase(0, end + 1);
    return line;
}

}  // namespace kickstand::ctl
