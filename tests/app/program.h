#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <string>
#include <vector>

#include <sys/types.h>

namespace kickstand::test {

/// What a program left behind.
struct Ended {
    int exitCode = -1;  ///< 128 + the signal, where one ended it.
    std::string out;
    std::string err;

    /// The lines of standard output, each as the JSON value that it is; an undefined one where it is none.
    std::vector<QJsonValue> values() const;
    /// The one JSON object that standard output is.
    QJsonObject object() const;
    /// Whether there is exactly one line on standard error, from the program of this name.
    bool oneComplaint(const std::string& program = "kickstandctl") const;
};

/// kickstandctl, or another program, started. Every wait is for something that happens, under a watchdog that
/// ends the program.
class Program {
  public:
    explicit Program(std::vector<std::string> arguments, const char* executable = KICKSTANDCTL);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Reads until this stands on standard output. False when the program ended, or the watchdog did it.
    bool waitFor(const std::string& text);
    void signal(int number) const;
    /// What came on standard output so far.
    const std::string& out() const { return ended_.out; }
    /// Leaves no room on standard output, as a reader does who has stopped reading.
    void fillPipe() const;
    /// Waits, reading nothing, until the program has ended; its exit code.
    int awaitExit();
    /// Nobody reads standard output any more.
    void closeOutput();
    /// Reads until the program has ended.
    Ended end();

  private:
    bool readSome();
    void closeEnd(int& descriptor);

    pid_t pid_ = -1;
    int out_ = -1;
    int err_ = -1;
    Ended ended_;
};

/// Runs kickstandctl, or another program, to its end.
Ended run(std::vector<std::string> arguments, const char* executable = KICKSTANDCTL);
/// The same over simulated robots: `--link sim:thunderbots?robots=0-3` before the arguments.
Ended runSimulated(std::vector<std::string> arguments);

}  // namespace kickstand::test
