#include "tests/rules/rules.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "tests/rules/layers.h"

namespace kickstand::rules {
namespace {

namespace fs = std::filesystem;

std::vector<Violation> checkAll(const Tree& tree) {
    std::vector<Violation> found = checkIncludes(tree);
    std::ranges::move(checkTexts(tree), std::back_inserter(found));
    return found;
}

/// "file:line" of each violation of one rule, sorted.
std::vector<std::string> placesOf(const std::vector<Violation>& found, std::string_view rule) {
    std::vector<std::string> places;
    for (const Violation& violation : found) {
        if (violation.rule == rule) places.push_back(violation.path + ":" + std::to_string(violation.line));
    }
    std::ranges::sort(places);
    return places;
}

std::vector<std::string> readLines(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

SourceFile fileOfLines(std::string path, std::size_t lines) {
    return {std::move(path), std::vector<std::string>(lines, "#pragma once")};
}

/// Ten files of ordinary length, and those that are given.
std::vector<Violation> checkBesideTen(const std::string& ending, std::vector<SourceFile> more) {
    Tree tree{std::move(more)};
    for (int i = 0; i < 10; ++i)
        tree.files.push_back(fileOfLines("app/short" + std::to_string(i) + ending, 20));
    return checkTexts(tree);
}

class FixtureTest : public testing::TestWithParam<std::string> {};

TEST_P(FixtureTest, TheRuleIsFoundBrokenExactlyWhereItIs) {
    const fs::path folder = fs::path(KICKSTAND_RULES_DATA) / GetParam();
    const std::vector<std::string> expected = readLines(folder / "expected.txt");
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(placesOf(checkAll(loadTree(folder)), GetParam()), expected);
}

INSTANTIATE_TEST_SUITE_P(Rules, FixtureTest,
                         testing::Values("layer", "library", "pure", "core-qt", "include-path", "pragma-once",
                                         "foreign-source", "readme", "unfinished", "machine-path",
                                         "untranslated"),
                         [](const auto& rule) {
                             std::string name = rule.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(RulesTest, ATreeThatKeepsTheRulesHasNoViolation) {
    const Tree tree = loadTree(fs::path(KICKSTAND_RULES_DATA) / "clean");
    ASSERT_GT(tree.files.size(), 15U);
    for (const Violation& violation : checkAll(tree)) {
        ADD_FAILURE() << violation.path << ':' << violation.line << ": " << violation.rule << ": "
                      << violation.message;
    }
}

TEST(RulesTest, EveryRuleButTheBudgetHasAFixture) {
    std::set<std::string_view> rules(std::begin(kRules), std::end(kRules));
    rules.erase(kBudget);
    for (const fs::directory_entry& entry : fs::directory_iterator(KICKSTAND_RULES_DATA)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory() && name != "clean") {
            EXPECT_EQ(rules.erase(name), 1U) << name << " is no rule";
        }
    }
    EXPECT_TRUE(rules.empty()) << *rules.begin() << " has no fixture";
}

TEST(RulesTest, EachRuleIsBrokenOnItsOwn) {
    // A message that names its remedy is worth little when three others come with it.
    const Tree tree{
        {{"core/base/a.h", {"#pragma once", "#include \"core/link/b.h\""}}, {"core/README.md", {"# core"}}}};
    const std::vector<Violation> found = checkAll(tree);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].rule, kLayer);
    EXPECT_NE(found[0].message.find("core/link/b.h"), std::string::npos);
}

TEST(BudgetTest, NoSourceIsLongerThanEightHundredLines) {
    EXPECT_TRUE(placesOf(checkBesideTen(".cpp", {fileOfLines("app/long.cpp", 800)}), kBudget).empty());
    EXPECT_EQ(placesOf(checkBesideTen(".cpp", {fileOfLines("app/long.cpp", 801)}), kBudget),
              std::vector<std::string>{"app/long.cpp:801"});
}

TEST(BudgetTest, NoHeaderIsLongerThanTwoHundredAndFiftyLines) {
    EXPECT_TRUE(placesOf(checkBesideTen(".h", {fileOfLines("app/long.h", 250)}), kBudget).empty());
    EXPECT_EQ(placesOf(checkBesideTen(".h", {fileOfLines("app/long.h", 251)}), kBudget),
              std::vector<std::string>{"app/long.h:251"});
}

TEST(BudgetTest, OneInTenMayBeLongerThanUsual) {
    EXPECT_TRUE(placesOf(checkBesideTen(".cpp", {fileOfLines("app/a.cpp", 450)}), kBudget).empty());
    EXPECT_TRUE(
        placesOf(checkBesideTen(".cpp", {fileOfLines("app/a.cpp", 449), fileOfLines("app/b.cpp", 449)}),
                 kBudget)
            .empty());
    EXPECT_EQ(placesOf(checkBesideTen(".cpp", {fileOfLines("app/a.cpp", 450), fileOfLines("app/b.cpp", 450)}),
                       kBudget),
              (std::vector<std::string>{"app/a.cpp:450", "app/b.cpp:450"}));
    EXPECT_EQ(
        placesOf(checkBesideTen(".h", {fileOfLines("app/a.h", 111), fileOfLines("app/b.h", 111)}), kBudget),
        (std::vector<std::string>{"app/a.h:111", "app/b.h:111"}));
}

TEST(LayersTest, AFolderOfCoreThatIsNotSharedIsASystem) {
    EXPECT_EQ(placeOf("core/fifth/model.h"), (Place{Layer::System, "fifth"}));
    EXPECT_EQ(placeOf("core/fifth/wire/frame.h"), (Place{Layer::Wire, "fifth"}));
    EXPECT_EQ(placeOf("core/fifth/sim/robot.h"), (Place{Layer::Sim, "fifth"}));
    EXPECT_EQ(placeOf("core/link/usb/libusb_link.h"), (Place{Layer::Link, "link"}));
    EXPECT_EQ(placeOf("core/telemetry/store.h"), (Place{Layer::Beside, "telemetry"}));
    EXPECT_EQ(placeOf("ui/traffic/inspector.h").layer, Layer::UiTraffic);
}

TEST(LayersTest, SimulatorsAreNamedByProgramsAndTestsAlone) {
    constexpr std::string_view kSim = "core/thunderbots/sim/dongle.h";
    EXPECT_TRUE(mayInclude("app/main.cpp", kSim));
    EXPECT_TRUE(mayInclude("tests/session/a_test.cpp", kSim));
    EXPECT_TRUE(mayInclude("core/thunderbots/sim/robot.cpp", kSim));
    for (const std::string_view from :
         {"core/engine/engine.cpp", "core/thunderbots/controller.cpp", "core/thunderbots/wire/drive.cpp",
          "ui/shell/window.cpp", "ui/traffic/inspector.cpp", "core/link/usb/libusb_link.cpp",
          "core/usbip/server.cpp", "core/telemetry/store.cpp"}) {
        EXPECT_FALSE(mayInclude(from, kSim)) << from;
    }
}

}  // namespace
}  // namespace kickstand::rules
