#include "app/kickstandctl/arguments.h"

#include <gtest/gtest.h>

namespace kickstand::ctl {
namespace {

Expected<Invocation> parse(std::vector<std::string> arguments) {
    return parseArguments(arguments);
}

TEST(Arguments, FindTheCommandWithItsOptions) {
    const auto invocation =
        parse({"thunderbots", "drive", "--robot", "3", "--wheels=-1,2,3,4", "--for", "2", "--dribble"});
    ASSERT_TRUE(invocation) << invocation.error().text.line().toStdString();
    EXPECT_STREQ(invocation->command->name, "thunderbots drive");
    EXPECT_EQ(invocation->text("--robot"), "3");
    EXPECT_EQ(invocation->text("--wheels"), "-1,2,3,4");
    EXPECT_TRUE(invocation->has("--dribble"));
    EXPECT_FALSE(invocation->has("--limit"));
    EXPECT_EQ(invocation->text("--limit"), "");
    EXPECT_FALSE(invocation->json);
    EXPECT_FALSE(invocation->link);
}

TEST(Arguments, TakeGlobalOptionsAnywhere) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"--link", "sim:thunderbots", "--json", "thunderbots", "status"},
             {"thunderbots", "--link=sim:thunderbots", "status", "--json"},
             {"thunderbots", "status", "--json", "--link", "sim:thunderbots"}}) {
        const auto invocation = parseArguments(arguments);
        ASSERT_TRUE(invocation);
        EXPECT_TRUE(invocation->json);
        ASSERT_TRUE(invocation->link);
        EXPECT_EQ(toString(*invocation->link), "sim:thunderbots");
    }
}

TEST(Arguments, TakeAValueThatBeginsWithADash) {
    const auto invocation =
        parse({"thunderbots", "drive", "--wheels", "-1,-2,-3,-4", "--robot", "3", "--for", "1"});
    ASSERT_TRUE(invocation);
    EXPECT_EQ(invocation->text("--wheels"), "-1,-2,-3,-4");
}

TEST(Arguments, KeepOperandsInOrder) {
    const auto invocation = parse({"decode", "thunderbots.kick", "cb", "80", "00"});
    ASSERT_TRUE(invocation);
    EXPECT_EQ(invocation->operands, (std::vector<std::string>{"thunderbots.kick", "cb", "80", "00"}));
}

TEST(Arguments, EndOptionsAtTwoDashes) {
    const auto invocation = parse({"encode", "thunderbots.drive", "--", "--json", "-x"});
    ASSERT_TRUE(invocation);
    EXPECT_FALSE(invocation->json);
    EXPECT_EQ(invocation->operands, (std::vector<std::string>{"thunderbots.drive", "--json", "-x"}));
}

TEST(Arguments, HelpNeedsNothingElse) {
    const auto whole = parse({"--help"});
    ASSERT_TRUE(whole);
    EXPECT_TRUE(whole->wantsHelp);
    EXPECT_EQ(whole->help, "");
    EXPECT_EQ(parse({"thunderbots", "--help"})->help, "thunderbots");
    EXPECT_EQ(parse({"thunderbots", "drive", "--help"})->help, "thunderbots drive");
    EXPECT_EQ(parse({"-h", "thunderbots", "drive", "--robot", "99"})->help, "thunderbots drive");
    EXPECT_TRUE(parse({"--version"})->wantsVersion);
}

TEST(Arguments, EveryMistakeIsBadUsageWithARemedy) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{{},
                                                                       {""},
                                                                       {"-"},
                                                                       {"--"},
                                                                       {"-x"},
                                                                       {"--x=1"},
                                                                       {"--link"},
                                                                       {"thunderbots"},
                                                                       {"thunderbots", ""},
                                                                       {"thunderbots", "help"},
                                                                       {"devices", "more"},
                                                                       {"devices", "--for", "1"},
                                                                       {"decode"},
                                                                       {"--json=yes", "devices"},
                                                                       {"--for"}}) {
        const auto invocation = parseArguments(arguments);
        ASSERT_FALSE(invocation);
        EXPECT_EQ(invocation.error().exitCode, kBadUsage);
        EXPECT_FALSE(invocation.error().text.what.isEmpty());
        EXPECT_FALSE(invocation.error().text.remedy.isEmpty());
    }
}

TEST(Nearest, FindsWhatWasMeant) {
    const std::vector<std::string> choices{"thunderbots drive", "thunderbots status", "devices", "--robot"};
    EXPECT_EQ(nearest("thunderbots driev", choices), "thunderbots drive");
    EXPECT_EQ(nearest("device", choices), "devices");
    EXPECT_EQ(nearest("--robots", choices), "--robot");
    EXPECT_EQ(nearest("something else entirely", choices), "");
    EXPECT_EQ(nearest("", choices), "");
    EXPECT_EQ(nearest(std::string(100000, 'x'), choices), "");
    EXPECT_EQ(nearest("devices", {}), "");
}

}  // namespace
}  // namespace kickstand::ctl
