#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/kickstandctl/failure.h"

namespace kickstand::sim {

struct Invocation;

/// One option of a command, as the parser takes it and --help shows it.
struct OptionSpec {
    const char* name;   ///< "--robots".
    const char* value;  ///< "LIST"; empty for a switch.
    const char* help;
};

/// One command: a family to simulate, or ctl.
struct CommandSpec {
    const char* name;      ///< "thunderbots".
    const char* operands;  ///< "ACTION …"; empty for none.
    std::size_t maxOperands;
    const char* summary;
    const char* details;
    std::span<const OptionSpec> options;
    const char* example;  ///< Without "kickstand-sim" itself.
    ctl::Outcome (*run)(const Invocation& invocation);
};

/// Every command, in the order in which --help lists them.
std::span<const CommandSpec> commands();

/// What somebody typed, understood.
struct Invocation {
    const CommandSpec* command = nullptr;  ///< Null where none was named: for help and version.
    bool wantsHelp = false;
    bool wantsVersion = false;
    std::map<std::string, std::string, std::less<>> options;  ///< "--port" to its text; switches to "".
    std::vector<std::string> operands;

    bool has(std::string_view option) const { return options.contains(option); }
    /// The text of an option; empty where it was not given.
    std::string_view text(std::string_view option) const;
};

}  // namespace kickstand::sim
