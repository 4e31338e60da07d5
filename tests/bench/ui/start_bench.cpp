// From exec to the first paint of the whole window with simulated robots connected, beside an empty Qt
// window's, in turn, in the same run. Prints JSON. QT_QPA_PLATFORM chooses the screen; without a display it
// must be "offscreen".

#include <QApplication>
#include <QWidget>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/bench/thunderbots/figures.h"
#include "ui/shell/first_paint.h"

namespace kickstand::bench {
namespace {

constexpr int kRuns = 20;
constexpr const char* kEmpty = "--empty";

/// The peer: a window with nothing in it, that says when it has been painted.
int showEmptyWindow(int argc, char** argv) {
    QApplication application(argc, argv);
    QWidget window;
    auto* firstPaint = new ui::FirstPaint(window);
    QObject::connect(firstPaint, &ui::FirstPaint::painted, &application, [] {
        std::puts("painted");
        std::fflush(stdout);
    });
    window.resize(1280, 800);
    window.show();
    return QApplication::exec();
}

/// Runs a program until it writes its first byte. Milliseconds, or less than zero where it never did.
double untilPainted_ms(std::vector<std::string> arguments) {
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) return -1;
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, pipe[0]);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const auto begin = std::chrono::steady_clock::now();
    const int failed = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe[1]);
    char byte = 0;
    const bool painted = failed == 0 && read(pipe[0], &byte, 1) == 1;
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    close(pipe[0]);
    if (failed != 0) return -1;
    kill(child, SIGTERM);
    waitpid(child, nullptr, 0);
    return painted ? took.count() : -1;
}

int measure(const char* self) {
    std::vector<double> empty;
    std::vector<double> whole;
    for (int run = 0; run <= kRuns; ++run) {
        const double empty_ms = untilPainted_ms({self, kEmpty});
        const double whole_ms =
            untilPainted_ms({KICKSTAND_PROGRAM, "--announce", "--link", "sim:thunderbots"});
        if (empty_ms < 0 || whole_ms < 0) {
            std::fprintf(stderr, "bench_start: a window was not painted\n");
            return 1;
        }
        // The first run reads the libraries from disk.
        if (run == 0) continue;
        empty.push_back(empty_ms);
        whole.push_back(whole_ms);
    }
    std::printf("{\n");
    printFigures("empty_window_ms", empty, ",");
    printFigures("kickstand_ms", whole, ",");
    std::printf("  \"ratio_p50\": %.2f\n}\n", quantile(whole, 0.5) / quantile(empty, 0.5));
    return 0;
}

}  // namespace
}  // namespace kickstand::bench

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], kickstand::bench::kEmpty) == 0) {
        return kickstand::bench::showEmptyWindow(argc, argv);
    }
    return kickstand::bench::measure(argv[0]);
}
