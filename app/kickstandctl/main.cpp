#include <QCoreApplication>
#include <algorithm>
#include <string>
#include <vector>

#include "app/kickstandctl/arguments.h"
#include "app/kickstandctl/help.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/words.h"

namespace {

using namespace kickstand;
using namespace kickstand::ctl;

int run(const Invocation& invocation) {
    Interruption interruption;
    Output output(invocation.json, interruption);
    if (invocation.wantsVersion || invocation.wantsHelp) {
        output.raw(invocation.wantsVersion ? versionText() : helpText(invocation.help));
        return output.failed() ? kFailed : kDone;
    }
    Outcome outcome = invocation.command->run({invocation, output, interruption});
    if (outcome && output.failed()) {
        outcome = failed({.code = Errc::Io});
        outcome.error().text = {
            Words::tr("Not everything could be written."), Words::tr("Check where the output goes."), {}};
    }
    if (outcome) return kDone;
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
    // A script that asked for JSON gets a value whatever was wrong with the rest.
    if (std::find(arguments.begin(), arguments.end(), "--json") != arguments.end()) {
        Interruption interruption;
        Output(true, interruption).value(QJsonObject{{QStringLiteral("error"), toJson(invocation.error())}});
    }
    Output::complain(invocation.error());
    return invocation.error().exitCode;
}
