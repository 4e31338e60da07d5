#pragma once

#include <QString>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/kickstandctl/failure.h"
#include "core/link/link_uri.h"

namespace kickstand::ctl {

class Interruption;
class Output;
struct Context;

/// One option of a command, as the parser takes it and --help shows it.
struct OptionSpec {
    const char* name;   ///< "--robot".
    const char* value;  ///< "N"; empty for a switch.
    const char* help;
    bool required = false;
};

/// One command: everything that the parser, --help and main() know of it.
struct CommandSpec {
    const char* name;      ///< "thunderbots drive".
    const char* operands;  ///< "MESSAGE HEX"; empty for none.
    std::size_t minOperands;
    std::size_t maxOperands;
    const char* summary;  ///< One line, for the list.
    const char* details;  ///< More, for its own help; may be empty.
    std::span<const OptionSpec> options;
    const char* example;  ///< Without "kickstandctl" itself.
    Outcome (*run)(const Context& context);
    /// What its own help lists besides, ready to print; null for nothing.
    QString (*list)() = nullptr;
};

/// Every command, in the order in which --help lists them.
std::span<const CommandSpec> commands();

/// What somebody typed, understood.
struct Invocation {
    const CommandSpec* command = nullptr;  ///< Null for help and version.
    std::string help;                      ///< Help on the commands that begin with this, when `wantsHelp`.
    bool wantsHelp = false;
    bool wantsVersion = false;
    bool json = false;
    std::optional<LinkUri> link;
    std::map<std::string, std::string, std::less<>> options;  ///< "--robot" to its text; switches to "".
    std::vector<std::string> operands;

    bool has(std::string_view option) const { return options.find(option) != options.end(); }
    /// The text of an option; empty where it was not given.
    std::string_view text(std::string_view option) const;
};

/// What a command works with.
struct Context {
    const Invocation& invocation;
    Output& output;
    Interruption& interruption;
};

}  // namespace kickstand::ctl
