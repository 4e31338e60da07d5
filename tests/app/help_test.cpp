#include "app/kickstandctl/help.h"

#include <QStringList>
#include <set>

#include <gtest/gtest.h>

#include "app/kickstandctl/arguments.h"
#include "core/thunderbots/wire/fields.h"

namespace kickstand::ctl {
namespace {

/// The words of an example, as a shell would hand them over: none of them is quoted.
std::vector<std::string> wordsOf(const char* example) {
    std::vector<std::string> words;
    for (const QString& word : QString::fromUtf8(example).split(QLatin1Char(' ')))
        words.push_back(word.toStdString());
    return words;
}

TEST(Help, EveryCommandHasASummaryAndAnExampleOfItself) {
    std::set<std::string> names;
    for (const CommandSpec& command : commands()) {
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
        EXPECT_TRUE(QString::fromUtf8(command.summary).endsWith(QLatin1Char('.'))) << command.name;
        const auto example = parseArguments(wordsOf(command.example));
        ASSERT_TRUE(example) << command.example << ": " << example.error().text.line().toStdString();
        EXPECT_STREQ(example->command->name, command.name);
    }
    EXPECT_GE(names.size(), 15U);
}

TEST(Help, ShowsEveryOptionOfACommand) {
    for (const CommandSpec& command : commands()) {
        const QString help = helpText(command.name);
        EXPECT_TRUE(help.contains(QString::fromUtf8(command.summary)));
        EXPECT_TRUE(help.contains(QStringLiteral("kickstandctl ") + QString::fromUtf8(command.example)));
        for (const OptionSpec& option : command.options) {
            EXPECT_TRUE(help.contains(QString::fromUtf8(option.name))) << command.name << option.name;
            EXPECT_TRUE(help.contains(QString::fromUtf8(option.help))) << command.name << option.name;
        }
        for (const char* global : {"--link URI", "--json", "--help", "--version"})
            EXPECT_TRUE(help.contains(QLatin1String(global))) << command.name << global;
    }
}

TEST(Help, OfTheCodecListsEveryMessage) {
    for (const char* command : {"decode", "encode"}) {
        const QString help = helpText(command);
        for (const auto& message : thunderbots::wire::messages())
            EXPECT_TRUE(help.contains(QString::fromUtf8(message.name))) << message.name;
    }
}

TEST(Help, ListsEveryCommand) {
    const QString help = helpText("");
    for (const CommandSpec& command : commands())
        EXPECT_TRUE(help.contains(QString::fromUtf8(command.name)));
}

TEST(Help, OfAGroupListsThatGroupAlone) {
    const QString help = helpText("thunderbots");
    EXPECT_TRUE(help.contains(QStringLiteral("thunderbots drive")));
    EXPECT_FALSE(help.contains(QStringLiteral("  encode")));
}

TEST(Help, OptionsOfOneNameAreOfOneKindEverywhere) {
    // The parser knows an option's kind before it knows the command.
    std::map<std::string, bool> isSwitch;
    for (const CommandSpec& command : commands()) {
        for (const OptionSpec& option : command.options) {
            const auto [known, isNew] = isSwitch.emplace(option.name, *option.value == '\0');
            EXPECT_TRUE(isNew || known->second == (*option.value == '\0')) << option.name;
        }
    }
}

}  // namespace
}  // namespace kickstand::ctl
