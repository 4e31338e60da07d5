#include <gtest/gtest.h>

#include "core/engine/describe_facts.h"

namespace kickstand {
namespace {

std::string filled(const char* text, const Error& error) {
    const auto result = fillFacts(QString::fromUtf8(text), error);
    return result ? result->toStdString() : "(nothing)";
}

Error someFacts() {
    Error error;
    error.subject = "wheel 1";
    error.robot = 3;
    error.endpoint = std::uint8_t{0x85};
    error.lowest = -100;
    error.got = 7;
    return error;
}

TEST(FillFacts, PutsFactsWhereTheyAreNamed) {
    EXPECT_EQ(filled("{subject} of robot {robot}: {got}, lowest {lowest}, endpoint {endpoint}, place {place}",
                     someFacts()),
              "wheel 1 of robot 3: 7, lowest -100, endpoint 0x85, place 8");
}

TEST(FillFacts, LeavesTextWithoutFactsAlone) {
    EXPECT_EQ(filled("Nothing to fill in.", someFacts()), "Nothing to fill in.");
    EXPECT_EQ(filled("", someFacts()), "");
}

TEST(FillFacts, DropsBracketsWhoseFactsAreMissing) {
    EXPECT_EQ(filled("A[ up to {highest}] and [robot {robot}].", someFacts()), "A and robot 3.");
    EXPECT_EQ(filled("[{detail}][{highest}]", someFacts()), "");
}

TEST(FillFacts, GivesNothingWhenAFactOutsideBracketsIsMissing) {
    EXPECT_EQ(filled("up to {highest}[ of {subject}]", someFacts()), "(nothing)");
    EXPECT_EQ(filled("{nonsense}", someFacts()), "(nothing)");
}

TEST(FillFacts, NeverReadsAFactAsATemplate) {
    Error error;
    error.subject = "[{detail}] {robot}";
    error.detail = "{subject}";
    EXPECT_EQ(filled("{subject}|{detail}", error), "[{detail}] {robot}|{subject}");
}

TEST(Printable, KeepsOneLineOfOrdinaryText) {
    EXPECT_EQ(printable("plain, µs and “quotes”").toStdString(), "plain, µs and “quotes”");
    EXPECT_EQ(printable("a\nb\r\x1b[31mc\td").toStdString(), "a\uFFFDb\uFFFD\uFFFD[31mc d");
    EXPECT_EQ(printable("left\u202Eright\u2028next").toStdString(), "left\uFFFDright\uFFFDnext");
}

TEST(Printable, CutsWhatIsVeryLong) {
    const QString shown = printable(std::string(100000, 'x'));
    EXPECT_LT(shown.size(), 500);
    EXPECT_TRUE(shown.endsWith(QChar(0x2026)));
}

TEST(Printable, TakesBytesThatAreNoText) {
    EXPECT_EQ(printable("\xff\xfe").toStdString(), "\uFFFD\uFFFD");
}

}  // namespace
}  // namespace kickstand
