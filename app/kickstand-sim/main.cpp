#include <QCoreApplication>
#include <algorithm>
#include <string>
#include <vector>

#include "app/kickstand-sim/arguments.h"
#include "app/kickstand-sim/help.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/output.h"

namespace {

using namespace kickstand;

constexpr const char* kProgram = "kickstand-sim";

int tell(const QString& text) {
    ctl::Interruption interruption;
    ctl::Output output(false, interruption);
    output.raw(text);
    return output.failed() ? ctl::kFailed : ctl::kDone;
}

}  // namespace

int main(int argc, char** argv) {
    ctl::reserveStandardStreams();
    const QCoreApplication application(argc, argv);
    const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    const auto invocation = sim::parseArguments(arguments);
    if (!invocation) {
        ctl::Output::complain(invocation.error(), kProgram);
        return invocation.error().exitCode;
    }
    if (invocation->wantsVersion) return tell(sim::versionText());
    if (invocation->wantsHelp) return tell(sim::helpText(invocation->command));
    const ctl::Outcome outcome = invocation->command->run(*invocation);
    if (outcome) return ctl::kDone;
    ctl::Output::complain(outcome.error(), kProgram);
    return outcome.error().exitCode;
}
