#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "core/link/pty/pty_speed.h"
#include "core/link/pty/pty_terminal.h"

namespace kickstand::pty {
namespace {

/// How often a terminal is looked at for somebody who opens it, or for another speed: the kernel does not
/// tell.
constexpr int kLookEvery_ms = 20;
constexpr std::size_t kMostWaiting = 65536;
constexpr std::size_t kPiece = 4096;
constexpr int kPiecesATurn = 16;

tl::unexpected<Error> failNow(const char* what) {
    return fail(Errc::Io, what, std::strerror(errno));
}

/// Makes the terminal pass every byte as it is. Opening and closing the host's end also makes the kernel say
/// from then on whether somebody holds it.
Result<void> makeRaw(const char* name) {
    const int slave = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (slave < 0) return failNow(name);
    termios settings{};
    Result<void> made;
    if (tcgetattr(slave, &settings) != 0) made = failNow(name);
    cfmakeraw(&settings);
    cfsetspeed(&settings, B115200);
    if (made && tcsetattr(slave, TCSANOW, &settings) != 0) made = failNow(name);
    ::close(slave);
    return made;
}

bool makeNonBlocking(int file) {
    const int flags = ::fcntl(file, F_GETFL);
    return flags >= 0 && ::fcntl(file, F_SETFL, flags | O_NONBLOCK) == 0 &&
           ::fcntl(file, F_SETFD, FD_CLOEXEC) == 0;
}

}  // namespace

Result<std::unique_ptr<Terminal>> Terminal::open(TerminalEvents events) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0) return failNow("pseudo-terminal");
    std::array<int, 2> wake{-1, -1};
    std::array<char, 128> name{};
    if (::grantpt(master) != 0 || ::unlockpt(master) != 0 ||
        ::ptsname_r(master, name.data(), name.size()) != 0 || ::pipe(wake.data()) != 0 ||
        !makeNonBlocking(master) || !makeNonBlocking(wake[0]) || !makeNonBlocking(wake[1])) {
        auto failed = failNow("pseudo-terminal");
        for (const int file : {master, wake[0], wake[1]}) {
            if (file >= 0) ::close(file);
        }
        return failed;
    }
    std::unique_ptr<Terminal> terminal(
        new Terminal(master, wake[0], wake[1], name.data(), std::move(events)));
    if (auto raw = makeRaw(name.data()); !raw) return fail(std::move(raw.error()));
    terminal->thread_ = std::thread([made = terminal.get()] { made->run(); });
    return terminal;
}

Terminal::Terminal(int master, int wakeRead, int wakeWrite, std::string name, TerminalEvents events)
    : master_(master),
      wakeRead_(wakeRead),
      wakeWrite_(wakeWrite),
      name_(std::move(name)),
      events_(std::move(events)) {}

Terminal::~Terminal() {
    ending_ = true;
    wake();
    if (thread_.joinable()) thread_.join();
    for (const int file : {master_, wakeRead_, wakeWrite_})
        ::close(file);
}

void Terminal::wake() const {
    // A full pipe wakes as well.
    const char byte = 0;
    [[maybe_unused]] const ssize_t written = ::write(wakeWrite_, &byte, 1);
}

bool Terminal::send(ByteView bytes) {
    {
        const std::lock_guard lock(mutex_);
        if (!heldShared_) return true;  // Nobody is there to miss it.
        if (bytes.size() > kMostWaiting - waiting_.size()) return false;
        waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    }
    wake();
    return true;
}

void Terminal::run() {
    while (turn()) {
    }
}

bool Terminal::turn() {
    bool sending = false;
    {
        const std::lock_guard lock(mutex_);
        sending = !waiting_.empty();
    }
    // While nobody holds the host's end the kernel reports a hang-up each time it is asked: it is then asked
    // only now and then.
    const short wanted = static_cast<short>(POLLIN | (sending ? POLLOUT : 0));
    std::array<pollfd, 2> files{pollfd{wakeRead_, POLLIN, 0}, pollfd{master_, wanted, 0}};
    ::poll(files.data(), held_ ? 2 : 1, kLookEvery_ms);
    if (!held_) ::poll(&files[1], 1, 0);
    if (ending_) return false;
    std::array<char, 64> drained{};
    while (::read(wakeRead_, drained.data(), drained.size()) > 0) {
    }
    // What was written before the hang-up is still there to be read.
    if ((files[1].revents & POLLIN) != 0) {
        setHeld(true);
        receive();
    }
    setHeld((files[1].revents & POLLHUP) == 0);
    if (held_) {
        sendWaiting();
        watchBaud();
    }
    return true;
}

void Terminal::setHeld(bool held) {
    if (held == held_) return;
    held_ = held;
    {
        const std::lock_guard lock(mutex_);
        heldShared_ = held;
        waiting_.clear();
    }
    if (!held) return events_.closed();
    baud_ = baudOf(master_).value_or(0);
    events_.opened(baud_);
}

void Terminal::watchBaud() {
    const std::optional<Baud> baud = baudOf(master_);
    if (baud && std::exchange(baud_, *baud) != *baud) events_.baudChanged(*baud);
}

void Terminal::receive() {
    watchBaud();
    for (int i = 0; i < kPiecesATurn; ++i) {
        std::vector<std::uint8_t> piece(kPiece);
        const ssize_t size = ::read(master_, piece.data(), piece.size());
        if (size <= 0) return;
        piece.resize(static_cast<std::size_t>(size));
        events_.received(std::move(piece));
    }
}

void Terminal::sendWaiting() {
    std::vector<std::uint8_t> piece;
    {
        const std::lock_guard lock(mutex_);
        piece.assign(waiting_.begin(),
                     waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(waiting_.size(), kPiece)));
    }
    if (piece.empty()) return;
    const ssize_t size = ::write(master_, piece.data(), piece.size());
    if (size <= 0) return;
    // Only this thread takes from the front.
    const std::lock_guard lock(mutex_);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(size));
}

}  // namespace kickstand::pty
