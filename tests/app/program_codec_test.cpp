// What works offline: --help, --version, decode and encode.

#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

TEST(ProgramOffline, SaysItsVersion) {
    const Ended ended = run({"--version"});
    EXPECT_EQ(ended.exitCode, 0);
    EXPECT_TRUE(ended.out.starts_with("kickstandctl ")) << ended.out;
}

TEST(ProgramOffline, HelpsWithAnExample) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--help"},
                                               {"-h"},
                                               {"thunderbots", "--help"},
                                               {"thunderbots", "drive", "--help"},
                                               {"--help", "decode"}}) {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.exitCode, 0);
        EXPECT_NE(ended.out.find("Example: kickstandctl "), std::string::npos) << ended.out;
        EXPECT_EQ(ended.err, "");
    }
}

struct DriveVector {
    const char* hex;
    std::vector<std::string> fields;
};
const DriveVector kDriveVectors[] = {
    {"80 00 00 00 00 00 00 00 00 00", {"run=1"}},
    {"80 7f e0 00 00 00 00 00 00 00", {"run=1", "wheel1=1023"}},
    {"80 80 20 00 00 00 00 00 00 00", {"run=1", "wheel1=-1023"}},
    {"80 00 00 00 00 7f f0 00 00 00", {"run=1", "wheel4=-1"}},
    {"80 00 00 00 00 00 0b 00 00 00", {"run=1", "test_class=5", "test_target=4"}},
    {"d4 00 00 00 00 00 00 32 2f 12", {"run=1", "charge=1", "mask1=1", "armed=1", "t1=100", "t2=47", "dt=9"}},
};

TEST(ProgramOffline, DriveBlocksBothWays) {
    const std::vector<std::string> names{"run",        "charge",      "dribble", "mask1",  "mask2",
                                         "armed",      "wheel1",      "wheel2",  "wheel3", "wheel4",
                                         "test_class", "test_target", "t1",      "t2",     "dt"};
    for (const DriveVector& vector : kDriveVectors) {
        std::vector<std::string> arguments{"encode", "thunderbots.drive"};
        arguments.insert(arguments.end(), vector.fields.begin(), vector.fields.end());
        const Ended encoded = run(arguments);
        EXPECT_EQ(encoded.exitCode, 0) << encoded.err;
        EXPECT_EQ(encoded.out, std::string(vector.hex) + '\n');

        const QJsonObject decoded = run({"--json", "decode", "thunderbots.drive", vector.hex}).object();
        ASSERT_EQ(decoded.size(), static_cast<qsizetype>(names.size()));
        std::vector<std::string> again;
        for (const std::string& name : names) {
            const QString key = QString::fromStdString(name);
            ASSERT_TRUE(decoded[key].isDouble()) << name;
            if (decoded[key].toInt() != 0) again.push_back(name + '=' + std::to_string(decoded[key].toInt()));
        }
        EXPECT_EQ(again, vector.fields);
    }
}

TEST(ProgramOffline, TakesHexInEveryUsualForm) {
    for (const std::vector<std::string>& hex : std::vector<std::vector<std::string>>{
             {"cb8000"}, {"CB", "80", "00"}, {"cb:80:00"}, {"0xcb 0x80 0x00"}}) {
        std::vector<std::string> arguments{"--json", "decode", "thunderbots.kick"};
        arguments.insert(arguments.end(), hex.begin(), hex.end());
        EXPECT_EQ(run(arguments).object()[QStringLiteral("t1")].toInt(), 75);
    }
}

TEST(ProgramOffline, AddsUnitsWhenAsked) {
    const QJsonObject decoded =
        run({"--json", "decode", "--units", "thunderbots.feedback", "01 84 03 00 08 9a 01 0a 00"}).object();
    EXPECT_EQ(decoded[QStringLiteral("battery")].toInt(), 0x384);
    EXPECT_NEAR(decoded[QStringLiteral("battery_V")].toDouble(), 16.09, 0.01);
    EXPECT_NEAR(decoded[QStringLiteral("capacitor_V")].toDouble(), 166.65, 0.01);
}

TEST(ProgramOffline, EncodesToJson) {
    const QJsonObject encoded =
        run({"--json", "encode", "thunderbots.kick", "t1=75", "mask1=1", "mask2=1"}).object();
    EXPECT_EQ(encoded[QStringLiteral("hex")].toString(), QStringLiteral("cb 80 00"));
    EXPECT_EQ(encoded[QStringLiteral("bytes")].toArray(), (QJsonArray{0xCB, 0x80, 0x00}));
}

TEST(ProgramOffline, SaysTheSameInEveryLocale) {
    const std::vector<std::string> arguments{"--json", "decode", "--units", "thunderbots.kick", "cb8000"};
    const Ended usual = run(arguments);
    for (const char* locale : {"C", "de_DE.UTF-8", "ar_EG.UTF-8", "no such locale"}) {
        ::setenv("LC_ALL", locale, 1);
        const Ended other = run(arguments);
        ::unsetenv("LC_ALL");
        EXPECT_EQ(other.out, usual.out) << locale;
        EXPECT_EQ(other.err, "") << locale;
    }
}

TEST(ProgramOffline, NeverTripsOverBytes) {
    std::mt19937 random(20110707);
    for (const char* message : {"thunderbots.drive", "thunderbots.feedback", "thunderbots.firmware-response",
                                "thunderbots.status"}) {
        for (int round = 0; round < 8; ++round) {
            std::string hex;
            const auto length = random() % 70;
            for (std::uint32_t i = 0; i < length; ++i) {
                constexpr char kDigits[] = "0123456789abcdef";
                hex += kDigits[random() % 16];
                hex += kDigits[random() % 16];
            }
            const Ended ended = run({"--json", "decode", message, hex});
            if (ended.exitCode == 0)
                EXPECT_TRUE(ended.values().at(0).isObject()) << message << ' ' << hex;
            else
                EXPECT_TRUE(ended.exitCode == 2 && ended.oneComplaint())
                    << message << ' ' << hex << ' ' << ended.err;
        }
    }
}

}  // namespace
}  // namespace kickstand::test
