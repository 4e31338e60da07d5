#include <csignal>

#include "app/kickstand-sim/end_signals.h"

namespace kickstand::sim {
namespace {

sigset_t endSignals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int number : {SIGINT, SIGTERM, SIGQUIT})
        sigaddset(&set, number);
    struct sigaction hangUp = {};
    sigaction(SIGHUP, nullptr, &hangUp);
    if (hangUp.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
    return set;
}

}  // namespace

EndSignals::EndSignals() {
    std::signal(SIGPIPE, SIG_IGN);
    const sigset_t set = endSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

std::string EndSignals::wait() {
    const sigset_t set = endSignals();
    int number = 0;
    while (sigwait(&set, &number) != 0) {
    }
    switch (number) {
        case SIGINT:
            return "SIGINT";
        case SIGHUP:
            return "SIGHUP";
        case SIGQUIT:
            return "SIGQUIT";
        default:
            return "SIGTERM";
    }
}

}  // namespace kickstand::sim
