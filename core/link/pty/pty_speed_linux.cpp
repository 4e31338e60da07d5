#include "core/link/pty/pty_speed.h"

// The kernel's own structure, which holds speeds as numbers: tcgetattr() knows only the usual ones, by codes.
// It cannot be included beside <termios.h>.
#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace kickstand::pty {

std::optional<Baud> baudOf(int terminal) {
    termios2 settings{};
    if (::ioctl(terminal, TCGETS2, &settings) != 0) return std::nullopt;
    return settings.c_ospeed;
}

}  // namespace kickstand::pty
