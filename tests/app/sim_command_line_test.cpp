#include <QJsonArray>
#include <QJsonDocument>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/kickstand-sim/arguments.h"
#include "app/kickstand-sim/ctl_words.h"
#include "app/kickstand-sim/help.h"
#include "app/kickstand-sim/line_reader.h"

namespace kickstand::sim {
namespace {

using Words = std::vector<std::string>;

TEST(SimArguments, AreTakenApart) {
    const auto invocation = parseArguments(Words{"thunderbots", "--usbip", "--port=0", "--robots", "0,3"});
    ASSERT_TRUE(invocation);
    EXPECT_STREQ(invocation->command->name, "thunderbots");
    EXPECT_TRUE(invocation->has("--usbip"));
    EXPECT_EQ(invocation->text("--port"), "0");
    EXPECT_EQ(invocation->text("--robots"), "0,3");
}

TEST(SimArguments, ANegativeNumberIsNoOption) {
    const auto invocation = parseArguments(Words{"ctl", "--json", "radio-failure", "-1"});
    ASSERT_TRUE(invocation);
    EXPECT_EQ(invocation->operands, (Words{"radio-failure", "-1"}));
}

TEST(SimArguments, BadUsageSaysWhatAndWhatToDo) {
    for (const Words& words : std::vector<Words>{{},
                                                 {"starships"},
                                                 {"--usbip", "thunderbots"},
                                                 {"thunderbots", "--usb"},
                                                 {"thunderbots", "--port"},
                                                 {"thunderbots", "--port", "--usbip"},
                                                 {"thunderbots", "--usbip=yes"},
                                                 {"thunderbots", "--usbip", "--usbip"},
                                                 {"thunderbots", "now"},
                                                 {"ctl", "a", "b", "c", "d"}}) {
        const auto invocation = parseArguments(words);
        ASSERT_FALSE(invocation) << testing::PrintToString(words);
        EXPECT_EQ(invocation.error().exitCode, ctl::kBadUsage);
        EXPECT_FALSE(invocation.error().text.what.isEmpty());
        EXPECT_FALSE(invocation.error().text.remedy.isEmpty());
    }
}

TEST(SimHelp, EveryCommandHasItsOptionsAndAnExampleOfItself) {
    for (const CommandSpec& command : commands()) {
        EXPECT_TRUE(helpText(nullptr).contains(QString::fromUtf8(command.summary)));
        const QString help = helpText(&command);
        for (const OptionSpec& option : command.options)
            EXPECT_TRUE(help.contains(QString::fromUtf8(option.help))) << option.name;
        Words words;
        for (const QString& word : QString::fromUtf8(command.example).split(QLatin1Char(' ')))
            words.push_back(word.toStdString());
        const auto example = parseArguments(words);
        ASSERT_TRUE(example) << command.example;
        EXPECT_STREQ(example->command->name, command.name);
    }
}

/// What a simulator with two actions and a shortcut says.
QJsonObject someActions() {
    return QJsonDocument::fromJson(R"({"of":"robot","actions":[
        {"name":"ball","of":"robot","unit":"0 or 1","lowest":0,"highest":1},
        {"name":"stall","of":null,"unit":"endpoint","lowest":0,"highest":255},
        {"name":"kill","of":"robot","action":"dead","value":1},
        {"name":"unplug","of":null,"action":"plugged","value":0}]})")
        .object();
}

TEST(CtlWords, BecomeRequests) {
    for (const auto& [words, request] : std::vector<std::pair<Words, const char*>>{
             {{"ball", "3", "1"}, R"({"request":"perform","action":"ball","robot":3,"value":1})"},
             {{"ball", "all", "0"}, R"({"request":"perform","action":"ball","robot":"all","value":0})"},
             {{"ball", "3", "yes"}, R"({"request":"perform","action":"ball","robot":3,"value":"yes"})"},
             {{"stall", "0x85"}, R"({"request":"perform","action":"stall","value":133})"},
             {{"stall", "-1.5"}, R"({"request":"perform","action":"stall","value":-1.5})"},
             {{"kill", "3"}, R"({"request":"perform","action":"kill","robot":3})"},
             {{"unplug"}, R"({"request":"perform","action":"unplug"})"}}) {
        const auto made = actionRequest(words, someActions());
        ASSERT_TRUE(made) << request;
        EXPECT_EQ(*made, QJsonDocument::fromJson(request).object()) << request;
    }
}

TEST(CtlWords, OfAnotherFormAreBadUsage) {
    for (const Words& words : std::vector<Words>{{"explode"},
                                                 {"ball"},
                                                 {"ball", "1"},
                                                 {"ball", "three", "1"},
                                                 {"ball", "-1", "1"},
                                                 {"kill"},
                                                 {"kill", "3", "1"},
                                                 {"unplug", "3"},
                                                 {"stall", "1", "2"}}) {
        const auto made = actionRequest(words, someActions());
        ASSERT_FALSE(made) << testing::PrintToString(words);
        EXPECT_EQ(made.error().exitCode, ctl::kBadUsage);
        EXPECT_FALSE(made.error().text.remedy.isEmpty());
    }
}

class Lines : public testing::Test {
  protected:
    void feed(const std::string& text) {
        reader.take(
            {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
            [this](ByteView line) { lines.emplace_back(line.begin(), line.end()); },
            [this] { lines.emplace_back("(too long)"); });
    }
    LineReader reader{8};
    Words lines;
};

TEST_F(Lines, ComeWholeHoweverTheyAreCut) {
    const std::string text = "one\ntwo\r\n\n12345678\nlast";
    for (const char c : text)
        feed({c});
    EXPECT_EQ(lines, (Words{"one", "two", "", "12345678"}));
    feed("\n");
    EXPECT_EQ(lines.back(), "last");
    lines.clear();
    feed(text + '\n');
    EXPECT_EQ(lines, (Words{"one", "two", "", "12345678", "last"}));
}

TEST_F(Lines, TooLongAreSaidOnceAndTheNextIsReadAgain) {
    for (int i = 0; i < 1000; ++i)
        feed("123456789");
    feed("\nnext\n123456789\n");
    EXPECT_EQ(lines, (Words{"(too long)", "next", "(too long)"}));
}

}  // namespace
}  // namespace kickstand::sim
