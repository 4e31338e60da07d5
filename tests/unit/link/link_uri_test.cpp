#include "core/link/link_uri.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

using Options = std::map<std::string, std::string>;

struct Good {
    const char* text;
    const char* scheme;
    const char* target;
    Options options;
};

class GoodUris : public ::testing::TestWithParam<Good> {};

TEST_P(GoodUris, AreTakenApartAndPutTogether) {
    const Good& good = GetParam();
    const auto uri = parseLinkUri(good.text);
    ASSERT_TRUE(uri) << uri.error().detail;
    EXPECT_EQ(uri->scheme, good.scheme);
    EXPECT_EQ(uri->target, good.target);
    EXPECT_EQ(uri->options, good.options);
    const auto again = parseLinkUri(toString(*uri));
    ASSERT_TRUE(again) << toString(*uri);
    EXPECT_EQ(*again, *uri);
}

INSTANTIATE_TEST_SUITE_P(
    LinkUri, GoodUris,
    ::testing::Values(Good{"sim:thunderbots?robots=0-15&loss=0.02&seed=1&radio=true",
                           "sim",
                           "thunderbots",
                           {{"robots", "0-15"}, {"loss", "0.02"}, {"seed", "1"}, {"radio", "true"}}},
                      Good{"sim:thunderbots?radio=ideal", "sim", "thunderbots", {{"radio", "ideal"}}},
                      Good{"sim:smartdevice?devices=PolarBear,BatteryBuzzer",
                           "sim",
                           "smartdevice",
                           {{"devices", "PolarBear,BatteryBuzzer"}}},
                      Good{"sim:coach", "sim", "coach", {}}, Good{"sim:motionplan", "sim", "motionplan", {}},
                      Good{"usb:", "usb", "", {}}, Good{"usb:?port=1-2.3", "usb", "", {{"port", "1-2.3"}}},
                      Good{"usb-cable:", "usb-cable", "", {}},
                      Good{"usbip:127.0.0.1:3240/1-1", "usbip", "127.0.0.1:3240/1-1", {}},
                      Good{"serial:/dev/ttyACM0?protocol=smartdevice&baud=115200",
                           "serial",
                           "/dev/ttyACM0",
                           {{"protocol", "smartdevice"}, {"baud", "115200"}}},
                      Good{"replay:/tmp/monday run.pcapng", "replay", "/tmp/monday run.pcapng", {}},
                      Good{"replay:a%3Fb%25c%20d%23.pcapng", "replay", "a?b%c d#.pcapng", {}},
                      Good{"replay:caf\xC3\xA9", "replay", "caf\xC3\xA9", {}},
                      Good{"SIM:Coach", "sim", "Coach", {}},
                      Good{"sim:x?text=a%26b%3Dc=d?e", "sim", "x", {{"text", "a&b=c=d?e"}}},
                      Good{"sim:x?empty=", "sim", "x", {{"empty", ""}}}));

struct Bad {
    std::string text;
    std::string piece;
    int at;
};

class BadUris : public ::testing::TestWithParam<Bad> {};

TEST_P(BadUris, NameTheirBadPiece) {
    const Bad& bad = GetParam();
    const auto uri = parseLinkUri(bad.text);
    ASSERT_FALSE(uri);
    EXPECT_EQ(uri.error().code, Errc::BadUri);
    EXPECT_EQ(uri.error().detail, bad.piece);
    EXPECT_EQ(uri.error().got, bad.at);
}

INSTANTIATE_TEST_SUITE_P(
    LinkUri, BadUris,
    ::testing::Values(Bad{"", "", 0}, Bad{"usb", "usb", 0}, Bad{":target", "", 0}, Bad{"1usb:", "1usb", 0},
                      Bad{"us b:", "us b", 0}, Bad{"-usb:", "-usb", 0}, Bad{"usb:?", "", 5},
                      Bad{"usb:?port", "port", 5}, Bad{"usb:?=1", "=1", 5}, Bad{"sim:x?a=1&", "", 10},
                      Bad{"sim:x?a=1&&b=2", "", 10}, Bad{"sim:x?a=1&b=2&a=3", "a=3", 14},
                      Bad{"sim:x?Robots=1", "Robots", 6}, Bad{"sim:x?a b=1", "a b", 6},
                      Bad{"sim:x?a%3D=1", "a%3D", 6}, Bad{"sim:x%", "%", 5}, Bad{"sim:x%4", "%4", 5},
                      Bad{"sim:x%zz", "%zz", 5}, Bad{"sim:x?a=%g0", "%g0", 8}, Bad{"sim:x%00", "%00", 5},
                      Bad{"sim:x%0A", "%0A", 5}, Bad{"sim:x\ny", "%0A", 5}, Bad{"sim:x\x7Fy", "%7F", 5},
                      Bad{"sim:x#y", "#", 5}, Bad{"sim:x?a=#", "#", 8},
                      Bad{std::string("sim:\0", 5), "%00", 4}, Bad{"\x1B[2J:x", "%1B[2J", 0}));

TEST(LinkUri, AnErrorNeverCarriesControlCharacters) {
    const auto uri = parseLinkUri("sim:a\x1B[31m?b");
    ASSERT_FALSE(uri);
    EXPECT_EQ(uri.error().subject, "sim:a%1B[31m?b");
}

TEST(LinkUri, OnlyTheSimSchemeIsSimulated) {
    EXPECT_TRUE(parseLinkUri("sim:coach")->isSimulated());
    EXPECT_FALSE(parseLinkUri("usb:")->isSimulated());
}

TEST(LinkUri, WhatAProgramPutsInComesOut) {
    LinkUri uri;
    uri.scheme = "replay";
    uri.target = "100 % of? #1";
    uri.options = {{"speed", "2 & a half%"}, {"a-b_c", "x=y"}};
    const auto read = parseLinkUri(toString(uri));
    ASSERT_TRUE(read) << toString(uri);
    EXPECT_EQ(*read, uri);
}

}  // namespace
}  // namespace kickstand
