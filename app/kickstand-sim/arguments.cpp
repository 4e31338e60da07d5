#include "app/kickstand-sim/arguments.h"

#include <algorithm>
#include <cctype>

#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

QString quoted(std::string_view text) {
    return QStringLiteral("“%1”").arg(printable(std::string(text)));
}

bool isOption(std::string_view argument) {
    if (argument.size() < 2 || argument[0] != '-') return false;
    const auto second = static_cast<unsigned char>(argument[1]);
    return std::isdigit(second) == 0 && second != '.';
}

/// Reads one command line from front to back.
class Parser {
  public:
    explicit Parser(std::span<const std::string> arguments) : arguments_(arguments) {}

    ctl::Expected<Invocation> parse() {
        while (at_ < arguments_.size()) {
            if (auto taken = takeOne(arguments_[at_++]); !taken) return tl::unexpected(taken.error());
        }
        const bool needsNone = invocation_.wantsHelp || invocation_.wantsVersion;
        if (invocation_.command == nullptr && !needsNone)
            return ctl::badUsage(Words::tr("Nothing was named that could be simulated."), listed());
        return std::move(invocation_);
    }

  private:
    ctl::Outcome takeOne(const std::string& argument) {
        if (!optionsEnded_ && argument == "--") {
            optionsEnded_ = true;
            return {};
        }
        if (!optionsEnded_ && isOption(argument)) return takeOption(argument);
        if (invocation_.command == nullptr) return takeCommand(argument);
        if (invocation_.operands.size() == invocation_.command->maxOperands)
            return ctl::badUsage(
                Words::tr("%1 is too much for %2.").arg(quoted(argument), quoted(invocation_.command->name)),
                helpHint());
        invocation_.operands.push_back(argument);
        return {};
    }

    ctl::Outcome takeCommand(std::string_view name) {
        for (const CommandSpec& command : commands()) {
            if (name == command.name) invocation_.command = &command;
        }
        if (invocation_.command != nullptr) return {};
        return ctl::badUsage(Words::tr("There is no %1 here.").arg(quoted(name)), listed());
    }

    const OptionSpec* findOption(std::string_view name) const {
        if (invocation_.command == nullptr) return nullptr;
        const auto& options = invocation_.command->options;
        const auto found =
            std::ranges::find_if(options, [&](const OptionSpec& option) { return name == option.name; });
        return found == options.end() ? nullptr : &*found;
    }

    ctl::Outcome takeOption(std::string_view argument) {
        if (argument == "--help" || argument == "-h") {
            invocation_.wantsHelp = true;
            return {};
        }
        if (argument == "--version") {
            invocation_.wantsVersion = true;
            return {};
        }
        const std::size_t equals = argument.find('=');
        const std::string name(argument.substr(0, equals));
        const OptionSpec* option = findOption(name);
        if (option == nullptr)
            return ctl::badUsage(Words::tr("There is no option %1 here.").arg(quoted(name)), helpHint());
        std::string value;
        if (equals != std::string_view::npos) value = argument.substr(equals + 1);
        if (*option->value == '\0') {
            if (equals != std::string_view::npos)
                return ctl::badUsage(Words::tr("%1 takes no value.").arg(quoted(name)),
                                     Words::tr("Leave out the “=”."));
        } else if (equals == std::string_view::npos) {
            if (at_ == arguments_.size() || isOption(arguments_[at_]))
                return ctl::badUsage(
                    Words::tr("%1 needs a value.").arg(quoted(name)),
                    Words::tr("Write it as %1 %2.").arg(printable(name), QString::fromUtf8(option->value)));
            value = arguments_[at_++];
        }
        if (!invocation_.options.emplace(name, std::move(value)).second)
            return ctl::badUsage(Words::tr("%1 was given twice.").arg(quoted(name)),
                                 Words::tr("Give it once."));
        return {};
    }

    static QString listed() {
        QStringList names;
        for (const CommandSpec& command : commands())
            names << QString::fromUtf8(command.name);
        return Words::tr("There is: %1. kickstand-sim --help says more.")
            .arg(names.join(QStringLiteral(", ")));
    }

    QString helpHint() const {
        if (invocation_.command == nullptr)
            return Words::tr("Options follow the name: kickstand-sim --help shows how.");
        return Words::tr("kickstand-sim %1 --help shows how it is used.")
            .arg(QString::fromUtf8(invocation_.command->name));
    }

    std::span<const std::string> arguments_;
    std::size_t at_ = 0;
    bool optionsEnded_ = false;
    Invocation invocation_;
};

}  // namespace

std::string_view Invocation::text(std::string_view option) const {
    const auto found = options.find(option);
    return found == options.end() ? std::string_view() : std::string_view(found->second);
}

ctl::Expected<Invocation> parseArguments(std::span<const std::string> arguments) {
    return Parser(arguments).parse();
}

}  // namespace kickstand::sim
