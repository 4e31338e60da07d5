#include "app/kickstandctl/arguments.h"

#include <algorithm>
#include <numeric>

#include "app/composition/composition.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::ctl {
namespace {

constexpr OptionSpec kGlobalOptions[] = {
    {"--link", "URI", ""}, {"--json", "", ""}, {"--help", "", ""}, {"--version", "", ""}};

QString quoted(std::string_view text) {
    return QStringLiteral("“%1”").arg(printable(std::string(text)));
}

std::size_t editDistance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < to.size(); ++j) {
            const std::size_t change = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

/// "Did you mean X?", or where everything is listed.
QString suggestion(std::string_view text, const std::vector<std::string>& choices, const QString& otherwise) {
    const std::string near = nearest(text, choices);
    if (near.empty()) return otherwise;
    return Words::tr("Did you mean %1?").arg(quoted(near));
}

std::vector<std::string_view> wordsOf(std::string_view name) {
    std::vector<std::string_view> words;
    while (!name.empty()) {
        const std::size_t space = std::min(name.find(' '), name.size());
        words.push_back(name.substr(0, space));
        name.remove_prefix(std::min(space + 1, name.size()));
    }
    return words;
}

/// Reads one command line from front to back.
class Parser {
  public:
    explicit Parser(std::span<const std::string> arguments) : arguments_(arguments) {}

    Expected<Invocation> parse() {
        if (auto taken = takeAll(); !taken) return tl::unexpected(std::move(taken.error()));
        if (invocation_.wantsVersion) return std::move(invocation_);
        if (auto found = findCommand(); !found) return tl::unexpected(std::move(found.error()));
        if (invocation_.wantsHelp) return std::move(invocation_);
        if (auto right = check(); !right) return tl::unexpected(std::move(right.error()));
        return std::move(invocation_);
    }

  private:
    Outcome takeAll() {
        bool optionsEnded = false;
        while (at_ < arguments_.size()) {
            const std::string& argument = arguments_[at_++];
            if (!optionsEnded && argument == "--") {
                optionsEnded = true;
            } else if (!optionsEnded && argument == "-h") {
                invocation_.wantsHelp = true;
            } else if (!optionsEnded && argument.size() > 1 && argument.starts_with("-")) {
                if (auto taken = takeOption(argument); !taken) return taken;
            } else {
                plain_.push_back(argument);
            }
        }
        return {};
    }

    /// Which options a command has is known once its words are: until then any command's may come.
    static const OptionSpec* findOption(std::string_view name) {
        for (const OptionSpec& option : kGlobalOptions) {
            if (name == option.name) return &option;
        }
        for (const CommandSpec& command : commands()) {
            for (const OptionSpec& option : command.options) {
                if (name == option.name) return &option;
            }
        }
        return nullptr;
    }

    Outcome takeOption(std::string_view argument) {
        const std::size_t equals = argument.find('=');
        const std::string name(argument.substr(0, equals));
        const OptionSpec* option = findOption(name);
        if (option == nullptr) return unknownOption(name);
        const bool isSwitch = *option->value == '\0';
        std::string value;
        if (equals != std::string_view::npos) {
            if (isSwitch)
                return badUsage(Words::tr("%1 takes no value.").arg(quoted(name)),
                                Words::tr("Leave out the “=”."));
            value = argument.substr(equals + 1);
        } else if (!isSwitch) {
            if (at_ == arguments_.size() || arguments_[at_].starts_with("--"))
                return badUsage(
                    Words::tr("%1 needs a value.").arg(quoted(name)),
                    Words::tr("Write it as %1 %2.").arg(printable(name), QString::fromUtf8(option->value)));
            value = arguments_[at_++];
        }
        return keep(name, std::move(value));
    }

    Outcome keep(const std::string& name, std::string value) {
        if (name == "--json") {
            invocation_.json = true;
        } else if (name == "--help") {
            invocation_.wantsHelp = true;
        } else if (name == "--version") {
            invocation_.wantsVersion = true;
        } else if (!invocation_.options.emplace(name, std::move(value)).second) {
            return badUsage(Words::tr("%1 was given twice.").arg(quoted(name)), Words::tr("Give it once."));
        }
        return {};
    }

    Outcome unknownOption(std::string_view name) const {
        std::vector<std::string> choices;
        for (const OptionSpec& option : kGlobalOptions)
            choices.emplace_back(option.name);
        for (const CommandSpec& command : commands()) {
            for (const OptionSpec& option : command.options)
                choices.emplace_back(option.name);
        }
        return badUsage(Words::tr("There is no option %1.").arg(quoted(name)),
                        suggestion(name, choices, Words::tr("kickstandctl --help lists what there is.")));
    }

    /// Takes the words of a command off the front of what is neither option nor value.
    Outcome findCommand() {
        if (plain_.empty()) {
            if (invocation_.wantsHelp) return {};
            return badUsage(Words::tr("No command was given."), Words::tr("kickstandctl --help lists them."));
        }
        for (const CommandSpec& command : commands()) {
            const auto words = wordsOf(command.name);
            if (plain_.size() < words.size() || !std::equal(words.begin(), words.end(), plain_.begin()))
                continue;
            invocation_.command = &command;
            invocation_.help = command.name;
            invocation_.operands.assign(plain_.begin() + static_cast<std::ptrdiff_t>(words.size()),
                                        plain_.end());
            return {};
        }
        return unknownCommand();
    }

    Outcome unknownCommand() {
        std::vector<std::string> choices;
        const bool isGroup =
            std::any_of(commands().begin(), commands().end(), [this](const CommandSpec& command) {
                return std::string_view(command.name).starts_with(plain_[0] + ' ');
            });
        if (isGroup && plain_.size() == 1 && invocation_.wantsHelp) {
            invocation_.help = plain_[0];
            return {};
        }
        if (isGroup && plain_.size() == 1)
            return badUsage(Words::tr("%1 needs a command of its own.").arg(quoted(plain_[0])),
                            Words::tr("kickstandctl %1 --help lists them.").arg(printable(plain_[0])));
        for (const CommandSpec& command : commands())
            choices.emplace_back(command.name);
        const std::string typed = isGroup ? plain_[0] + ' ' + plain_[1] : plain_[0];
        return badUsage(Words::tr("There is no command %1.").arg(quoted(typed)),
                        suggestion(typed, choices, Words::tr("kickstandctl --help lists what there is.")));
    }

    Outcome check() {
        const CommandSpec& command = *invocation_.command;
        const QString help =
            Words::tr("kickstandctl %1 --help shows how it is used.").arg(QString::fromUtf8(command.name));
        const QString name = quoted(command.name);
        if (auto link = takeLink(); !link) return link;
        for (const auto& [given, value] : invocation_.options) {
            const bool known =
                std::any_of(command.options.begin(), command.options.end(),
                            [&given = given](const OptionSpec& option) { return given == option.name; });
            if (!known) return badUsage(Words::tr("%1 takes no %2.").arg(name, quoted(given)), help);
        }
        for (const OptionSpec& option : command.options) {
            if (option.required && !invocation_.has(option.name))
                return badUsage(Words::tr("%1 needs %2.").arg(name, QString::fromUtf8(option.name)), help);
        }
        if (invocation_.operands.size() < command.minOperands)
            return badUsage(Words::tr("%1 needs %2.").arg(name, QString::fromUtf8(command.operands)), help);
        if (invocation_.operands.size() > command.maxOperands)
            return badUsage(Words::tr("%1 is too much for %2.")
                                .arg(quoted(invocation_.operands[command.maxOperands]), name),
                            help);
        return {};
    }

    Outcome takeLink() {
        const auto link = invocation_.options.find("--link");
        if (link == invocation_.options.end()) return {};
        auto uri = parseLinkUri(link->second);
        if (!uri) return refusedInput(uri.error());
        if (const auto exists = checkLink(*uri); !exists) return refusedInput(exists.error());
        invocation_.link = std::move(*uri);
        invocation_.options.erase(link);
        return {};
    }

    std::span<const std::string> arguments_;
    std::size_t at_ = 0;
    std::vector<std::string> plain_;
    Invocation invocation_;
};

}  // namespace

std::string_view Invocation::text(std::string_view option) const {
    const auto found = options.find(option);
    return found == options.end() ? std::string_view() : std::string_view(found->second);
}

std::string nearest(std::string_view text, std::span<const std::string> choices) {
    std::string best;
    // Further away than this nobody would have meant it.
    std::size_t bestDistance = std::max<std::size_t>(2, text.size() / 3) + 1;
    if (text.size() > 64) return best;
    for (const std::string& choice : choices) {
        const std::size_t distance = editDistance(text, choice);
        if (distance >= bestDistance) continue;
        bestDistance = distance;
        best = choice;
    }
    return best;
}

Expected<Invocation> parseArguments(std::span<const std::string> arguments) {
    return Parser(arguments).parse();
}

}  // namespace kickstand::ctl
