#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "app/kickstandctl/interruption.h"

namespace kickstand::ctl {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP, SIGQUIT};

// A signal handler reaches nothing but statics: the pipe by which it wakes the main loop.
int wakeRead = -1;
int wakeWrite = -1;

extern "C" void onSignal(int number) {
    const int before = errno;
    const auto byte = static_cast<unsigned char>(number);
    // A full pipe holds a signal already.
    (void)!::write(wakeWrite, &byte, 1);
    errno = before;
}

const char* nameOf(int number) {
    switch (number) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGHUP:
            return "SIGHUP";
        case SIGQUIT:
            return "SIGQUIT";
        default:
            return "a signal";
    }
}

}  // namespace

Interruption::Interruption() {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) == 0) {
        wakeRead = ends[0];
        wakeWrite = ends[1];
    }
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    for (const int number : kSignals) {
        struct sigaction before = {};
        sigaction(number, &action, &before);
        // Whoever starts it under nohup wants it to outlive the terminal.
        if (number == SIGHUP && before.sa_handler == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
    }
    std::signal(SIGPIPE, SIG_IGN);
}

Interruption::~Interruption() {
    for (const int number : kSignals)
        std::signal(number, SIG_DFL);
    ::close(std::exchange(wakeRead, -1));
    ::close(std::exchange(wakeWrite, -1));
}

void Interruption::wait(Duration limit) {
    std::array<pollfd, 2> watched{pollfd{wakeRead, POLLIN, 0}, pollfd{STDOUT_FILENO, 0, 0}};
    // Once it is over, only the time counts: what has come would be there at once, every time.
    const nfds_t count = cause_ ? 0 : watched.size();
    const auto limit_ms = std::chrono::ceil<std::chrono::milliseconds>(limit).count();
    if (::poll(watched.data(), count, static_cast<int>(limit_ms)) <= 0 || cause_) return;
    unsigned char number = 0;
    if ((watched[0].revents & POLLIN) != 0 && ::read(wakeRead, &number, 1) == 1) {
        cause_ = nameOf(number);
        isRequest_ = number == SIGINT || number == SIGTERM;
    } else if (watched[1].revents != 0) {
        cause_ = "the reader of the output is gone";
    }
}

}  // namespace kickstand::ctl
