#include <QCoreApplication>
#include <algorithm>
#include <string>
#include <vector>

#include "app/kickstandctl/arguments.h"
#include "app/kickstandctl/help.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"

namespace {

using namespace kickstand;
using namespace kickstand::ctl;

int run(const Invocation& invocation) {
    Output output(invocation.json);
    if (invocation.wantsVersion || invocation.wantsHelp) {
        output.raw(invocation.wantsVersion ? versionText() : helpText(invocation.help));
        return output.failed() ? kFailed : kDone;
    }
    Interruption interruption;
    const Outcome outcome = invocation.command->run({invocation, output, interruption});
    if (outcome) return output.failed() ? kFailed : kDone;
    if (!output.hasValue()) output.value(QJsonObject{{QStringLiteral("error"), toJson(outcome.error())}});
    Output::complain(outcome.error());
    return outcome.error().exitCode;
}

}  // namespace

int main(int argc, char** argv) {
    reserveStandardStreams();
    const QCoreApplication application(argc, argv);
    const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    const auto invocation = parseArguments(arguments);
    if (invocation) return run(*invocation);
    Output::complain(invocation.error());
    return invocation.error().exitCode;
}
