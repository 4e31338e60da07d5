#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "core/engine/describe.h"
#include "core/engine/describe_error_texts.h"

namespace kickstand {
namespace {

/// Every code there is: their names stop at the first number that has none.
std::vector<Errc> allCodes() {
    std::vector<Errc> codes;
    for (int number = 0; std::string(name(static_cast<Errc>(number))) != "unknown"; ++number)
        codes.push_back(static_cast<Errc>(number));
    return codes;
}

Error errorOf(Errc code) {
    Error error;
    error.code = code;
    return error;
}

std::string whatOf(const Error& error) {
    return describe(error).what.toStdString();
}
std::string lineOf(const Error& error) {
    return describe(error).line().toStdString();
}

TEST(DescribeError, EveryCodeHasItsOwnSentenceWithNoFactsAtAll) {
    std::map<std::string, Errc> seen;
    ASSERT_GE(allCodes().size(), 30U);
    const std::string noWords = whatOf(errorOf(static_cast<Errc>(250)));
    for (const Errc code : allCodes()) {
        const std::string what = whatOf(errorOf(code));
        EXPECT_TRUE(what.ends_with('.')) << name(code) << ": " << what;
        EXPECT_NE(what, noWords) << name(code);
        EXPECT_EQ(what.find_first_of("{}[]"), std::string::npos) << name(code) << ": " << what;
        const auto [other, isNew] = seen.emplace(what, code);
        EXPECT_TRUE(isNew) << name(code) << " says the same as " << name(other->second);
    }
}

TEST(DescribeError, EveryCodeSaysWhatToDo) {
    for (const Errc code : allCodes())
        EXPECT_FALSE(describe(errorOf(code)).remedy.isEmpty()) << name(code);
}

TEST(DescribeError, WithAllFactsNothingIsLeftUnfilled) {
    for (const Errc code : allCodes()) {
        Error error = errorOf(code);
        error.subject = "SUBJECT";
        error.detail = "DETAIL";
        error.robot = 3;
        error.endpoint = std::uint8_t{0x05};
        error.lowest = 1;
        error.highest = 2;
        error.got = 4;
        const Description description = describe(error);
        const std::string sentences = (description.what + description.remedy).toStdString();
        EXPECT_EQ(sentences.find_first_of("{}[]\n"), std::string::npos) << sentences;
    }
}

TEST(DescribeError, EveryTemplateIsReached) {
    std::set<const char*> unreachable;
    for (const ErrorText& text : errorTexts()) {
        // Exactly the facts that the template names outside brackets, so that a row above cannot win by
        // chance.
        const std::string whole = std::string(text.what) + text.remedy;
        Error error = errorOf(text.code);
        const auto names = [&](const char* fact) { return whole.find(fact) != std::string::npos; };
        if (names("{subject}")) error.subject = "s";
        if (*text.onlyFor != '\0') error.subject = text.onlyFor;
        if (names("{detail}")) error.detail = "d";
        if (names("{port}")) error.port = "p";
        if (names("{robot}")) error.robot = 1;
        if (names("{lowest}")) error.lowest = 1;
        if (names("{highest}")) error.highest = 9;
        if (names("{got}") || names("{place}")) error.got = 5;
        const std::string start =
            std::string(text.what).substr(0, std::string(text.what).find_first_of("{["));
        if (!whatOf(error).starts_with(start)) unreachable.insert(text.what);
    }
    for (const char* text : unreachable)
        ADD_FAILURE() << text;
}

TEST(DescribeError, NamesValueAndRange) {
    Error error = errorOf(Errc::OutOfRange);
    error.subject = "thunderbots.drive wheel1";
    error.got = -1024;
    error.lowest = -1023;
    error.highest = 1023;
    EXPECT_EQ(lineOf(error), "thunderbots.drive wheel1 is -1024. Choose a value from -1023 to 1023.");
}

TEST(DescribeError, NamesTheSerialPortAndWhatToDoAboutIt) {
    Error error = errorOf(Errc::PermissionDenied);
    error.port = "/dev/ttyACM0";
    EXPECT_EQ(whatOf(error), "This user may not open the serial port /dev/ttyACM0.");
    EXPECT_EQ(describe(error).remedyCommand,
              QStringLiteral("sudo usermod --append --groups dialout \"$USER\""));
    error.code = Errc::ClaimedElsewhere;
    EXPECT_EQ(whatOf(error), "Another program holds the serial port /dev/ttyACM0.");
    error.code = Errc::NoDevice;
    EXPECT_EQ(whatOf(error), "There is no serial port /dev/ttyACM0.");
}

TEST(DescribeError, ARefusalOfARobotWithPlansSaysWhatHelpsAgainstThatOne) {
    Error error = errorOf(Errc::WouldBeRefused);
    error.subject = "adjust-idle";
    error.detail = "no plan is executing";
    error.got = 7;
    EXPECT_EQ(lineOf(error),
              "Not sent, because the robot would refuse it: no plan is executing (error 7). Execute a plan "
              "first, and adjust it before it ends.");
    error.code = Errc::PlanRefused;
    EXPECT_NE(lineOf(error).find("Execute a plan first"), std::string::npos);
    error.subject = "slot-full";
    EXPECT_NE(lineOf(error).find("Query the slot"), std::string::npos);
}

TEST(DescribeError, OnlyWhatIsNeverSentAgainIsSaidNotToBe) {
    Error error = errorOf(Errc::Unconfirmed);
    const std::string never = "not sent again unasked";
    for (const char* subject : {"execute", "adjust", "adjust-arrived"}) {
        error.subject = subject;
        EXPECT_NE(lineOf(error).find(never), std::string::npos) << subject;
    }
    for (const char* subject : {"create", "update", "trigger", "stop", ""}) {
        error.subject = subject;
        EXPECT_EQ(lineOf(error).find(never), std::string::npos) << subject;
    }
    error.code = Errc::EchoDiffers;
    for (const char* subject : {"execute", "adjust"}) {
        error.subject = subject;
        EXPECT_EQ(lineOf(error).find("Send it again"), std::string::npos) << subject;
        EXPECT_NE(lineOf(error).find("Look at the robot"), std::string::npos) << subject;
    }
    error.subject = "create";
    EXPECT_NE(lineOf(error).find("Send it again"), std::string::npos);
}

TEST(DescribeError, ARangeThatNoWholeNumbersNameStandsInTheSentence) {
    Error error = errorOf(Errc::OutOfRange);
    error.subject = "pace";
    error.detail = "0 (0.1 to 100)";
    EXPECT_EQ(lineOf(error), "pace is out of range: 0 (0.1 to 100). Choose a value within its range.");
}

TEST(DescribeError, NamesTheRobot) {
    Error error = errorOf(Errc::RobotNotAlive);
    EXPECT_EQ(whatOf(error), "The robot is not heard.");
    error.robot = 12;
    EXPECT_EQ(whatOf(error), "Robot 12 is not heard.");
    EXPECT_EQ(whatOf({.code = Errc::RobotNotAlive, .got = 7}), "TOWRP 7 is not heard.");
}

TEST(DescribeError, TellsThePieceOfALinkThatCannotBeReadFromALinkThatIsNotTaken) {
    Error error = errorOf(Errc::BadUri);
    error.subject = "usb:?port";
    error.detail = "port";
    EXPECT_EQ(lineOf(error), "“usb:?port” is not a link that can be opened here. Accepted: port.");
    error.got = 5;
    EXPECT_TRUE(whatOf(error).find("“port”, from character 6 on") != std::string::npos) << whatOf(error);
}

TEST(DescribeError, PermissionComesWithACommandThatInstallsTheRule) {
    const Description description = describe(errorOf(Errc::PermissionDenied));
    EXPECT_EQ(description.remedy.toStdString(), "Install the udev rule:");
    EXPECT_TRUE(description.line().endsWith(description.remedyCommand));

    std::ifstream file(KICKSTAND_SOURCE_DIR "/packaging/udev/60-kickstand.rules");
    std::stringstream rules;
    rules << file.rdbuf();
    for (const char* fact :
         {"04d8", "7839", "783a", "TAG+=\"uaccess\"", "GROUP=\"plugdev\"", "MODE=\"0660\""}) {
        EXPECT_NE(rules.str().find(fact), std::string::npos) << fact << " is not in the installed rule";
        EXPECT_TRUE(description.remedyCommand.contains(QString::fromUtf8(fact)))
            << fact << " is not in the command";
    }
    EXPECT_TRUE(description.remedyCommand.contains(QStringLiteral("60-kickstand.rules")));
}

TEST(DescribeError, StaysInOneLineWhateverTheFactsHold) {
    for (const Errc code : allCodes()) {
        Error error = errorOf(code);
        error.subject = "two\nlines";
        error.detail = "\x1b[2Jclear\r\n";
        for (const QChar c : describe(error).line())
            EXPECT_TRUE(c.isPrint()) << name(code);
    }
}

}  // namespace
}  // namespace kickstand
