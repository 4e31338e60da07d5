#include "tests/app/program.h"

#include <QJsonDocument>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace kickstand::test {
namespace {

constexpr auto kWatchdog = std::chrono::seconds(60);

/// A pipe whose ends no other program inherits.
std::pair<int, int> makePipe() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    return {ends[0], ends[1]};
}

}  // namespace

std::vector<QJsonValue> Ended::values() const {
    std::vector<QJsonValue> all;
    for (const QByteArray& line : QByteArray::fromStdString(out).split('\n')) {
        if (line.isEmpty()) continue;
        const QJsonDocument document = QJsonDocument::fromJson(line);
        all.push_back(document.isObject()  ? QJsonValue(document.object())
                      : document.isArray() ? QJsonValue(document.array())
                                           : QJsonValue(QJsonValue::Undefined));
    }
    return all;
}

QJsonObject Ended::object() const {
    const auto all = values();
    EXPECT_EQ(all.size(), 1U) << out;
    return all.size() == 1 ? all[0].toObject() : QJsonObject();
}

bool Ended::oneComplaint(const std::string& program) const {
    return err.starts_with(program + ": ") && err.find('\n') == err.size() - 1;
}

Program::Program(std::vector<std::string> arguments, const char* executable) {
    arguments.insert(arguments.begin(), executable);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    const auto [outRead, outWrite] = makePipe();
    const auto [errRead, errWrite] = makePipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, outWrite, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errWrite, STDERR_FILENO);
    EXPECT_EQ(posix_spawn(&pid_, executable, &actions, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(outWrite);
    ::close(errWrite);
    out_ = outRead;
    err_ = errRead;
}

Program::~Program() {
    if (pid_ > 0) {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    closeOutput();
    closeEnd(err_);
}

void Program::closeEnd(int& descriptor) {
    if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

void Program::closeOutput() {
    closeEnd(out_);
}

void Program::signal(int number) const {
    ::kill(pid_, number);
}

/// Takes what there is, after waiting for it. False when there is nothing left to come.
bool Program::readSome() {
    std::vector<std::pair<int*, std::string*>> ends;
    std::vector<pollfd> watched;
    for (const auto& end : {std::pair{&out_, &ended_.out}, std::pair{&err_, &ended_.err}}) {
        if (*end.first < 0) continue;
        ends.emplace_back(end);
        watched.push_back({*end.first, POLLIN, 0});
    }
    if (watched.empty()) return false;
    const auto limit_ms = std::chrono::duration_cast<std::chrono::milliseconds>(kWatchdog).count();
    if (::poll(watched.data(), watched.size(), static_cast<int>(limit_ms)) <= 0) {
        ADD_FAILURE() << "the program neither said anything nor ended; so far: " << ended_.out << ended_.err;
        ::kill(pid_, SIGKILL);
        return false;
    }
    for (std::size_t i = 0; i < watched.size(); ++i) {
        if (watched[i].revents == 0) continue;
        char buffer[4096];
        const ssize_t count = ::read(watched[i].fd, buffer, sizeof buffer);
        if (count > 0)
            ends[i].second->append(buffer, static_cast<std::size_t>(count));
        else
            closeEnd(*ends[i].first);
    }
    return true;
}

bool Program::waitFor(const std::string& text) {
    while (ended_.out.find(text) == std::string::npos) {
        if (!readSome()) return false;
    }
    return true;
}

void Program::fillPipe() const {
    const std::string writeEnd = "/proc/self/fd/" + std::to_string(out_);
    const int descriptor = ::open(writeEnd.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(descriptor, 0);
    const std::string line(PIPE_BUF, '\n');
    while (::write(descriptor, line.data(), line.size()) > 0) {
    }
    EXPECT_EQ(errno, EAGAIN);
    ::close(descriptor);
}

int Program::awaitExit() {
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Ended Program::end() {
    while (readSome()) {
    }
    ended_.exitCode = awaitExit();
    return ended_;
}

Ended run(std::vector<std::string> arguments, const char* executable) {
    return Program(std::move(arguments), executable).end();
}

Ended runSimulated(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"--link", "sim:thunderbots?robots=0-3"});
    return run(std::move(arguments));
}

}  // namespace kickstand::test
