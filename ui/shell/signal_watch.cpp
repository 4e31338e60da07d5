#include "ui/shell/signal_watch.h"

#include <QSocketNotifier>
#include <atomic>
#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace kickstand::ui {

namespace {

constexpr std::array kSignals = {SIGTERM, SIGINT, SIGHUP};

/// The writing end, for the handler: the only thing that it may touch.
std::atomic<int> writeEnd = -1;

void handle(int) {
    const int saved = errno;
    const char byte = 0;
    // A full pipe says already what this byte would.
    [[maybe_unused]] const ssize_t written = write(writeEnd.load(), &byte, 1);
    errno = saved;
}

}  // namespace

SignalWatch::SignalWatch(QObject* parent) : QObject(parent) {
    if (pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
    writeEnd = pipe_[1];
    auto* notifier = new QSocketNotifier(pipe_[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        std::array<char, 16> bytes{};
        while (read(pipe_[0], bytes.data(), bytes.size()) > 0)
            continue;
        emit quitAsked();
    });
    struct sigaction action = {};
    action.sa_handler = handle;
    sigemptyset(&action.sa_mask);
    for (const int signal : kSignals)
        sigaction(signal, &action, nullptr);
}

SignalWatch::~SignalWatch() {
    if (pipe_[0] < 0) return;
    struct sigaction action = {};
    action.sa_handler = SIG_DFL;
    for (const int signal : kSignals)
        sigaction(signal, &action, nullptr);
    writeEnd = -1;
    close(pipe_[0]);
    close(pipe_[1]);
}

}  // namespace kickstand::ui
