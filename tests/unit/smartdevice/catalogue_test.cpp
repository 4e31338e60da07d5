#include "core/smartdevice/catalogue.h"

#include <gtest/gtest.h>

namespace kickstand::smartdevice {
namespace {

std::string file(const std::string& devices) {
    return R"({"format": "kickstand-smart-devices", "version": 1, "devices": [)" + devices + "]}";
}

std::string device(const std::string& parameters) {
    return file(R"({"id": 200, "name": "Thing", "parameters": [)" + parameters + "]}");
}

std::string refusal(const std::string& text) {
    const auto catalogue = readCatalogue(text, "mine.json");
    EXPECT_FALSE(catalogue) << text;
    if (catalogue) return {};
    EXPECT_EQ(catalogue.error().code, Errc::Malformed);
    EXPECT_EQ(catalogue.error().subject, "mine.json");
    return catalogue.error().detail;
}

TEST(Catalogue, HasEveryBoardOfTheKit) {
    const auto catalogue = makeCatalogue();
    ASSERT_TRUE(catalogue) << catalogue.error().detail;
    struct Kind {
        int id;
        const char* name;
        std::size_t parameters;
    };
    constexpr Kind kKinds[] = {{0, "LimitSwitch", 3}, {1, "LineFollower", 3},    {2, "Potentiometer", 3},
                               {3, "Encoder", 1},     {4, "BatteryBuzzer", 8},   {5, "TeamFlag", 7},
                               {6, "Grizzly", 0},     {7, "ServoControl", 2},    {8, "LinearActuator", 0},
                               {9, "ColorSensor", 0}, {10, "YogiBear", 14},      {11, "RFID", 2},
                               {12, "PolarBear", 14}, {16, "DistanceSensor", 0}, {17, "MetalDetector", 0}};
    EXPECT_EQ(catalogue->devices().size(), std::size(kKinds));
    for (const Kind& kind : kKinds) {
        const auto found = catalogue->find(static_cast<std::uint16_t>(kind.id));
        ASSERT_TRUE(found) << kind.name;
        EXPECT_EQ(found->name, kind.name);
        EXPECT_EQ(found->parameters.size(), kind.parameters) << kind.name;
        EXPECT_EQ(found->reserved, kind.parameters == 0) << kind.name;
        EXPECT_EQ(catalogue->find(kind.name), found);
    }
    EXPECT_EQ(catalogue->find(13), nullptr);
}

TEST(Catalogue, APolarBearIsAsTheDocumentHasIt) {
    const auto bear = makeCatalogue()->find("PolarBear");
    EXPECT_EQ(bear->readable(), 0b11'1100'0000'0001);
    EXPECT_EQ(bear->writable(), 0b10'0111'1111'1111);
    EXPECT_EQ(bear->find("enc_vel"), 11);
    EXPECT_EQ(bear->find("nothing"), -1);
    const ParameterSpec& duty = bear->parameters[0];
    EXPECT_EQ(duty.lowest, -1.0);
    EXPECT_EQ(duty.highest, 1.0);
    // STOP zeroes what drives, never a place.
    EXPECT_TRUE(duty.zeroOnStop);
    EXPECT_TRUE(bear->parameters[5].zeroOnStop);
    EXPECT_FALSE(bear->parameters[1].zeroOnStop);
    EXPECT_TRUE(duty.moves);
    EXPECT_TRUE(bear->parameters[1].moves);
    EXPECT_FALSE(bear->parameters[2].moves);
    EXPECT_TRUE(makeCatalogue()->find("ServoControl")->parameters[0].moves);
    EXPECT_EQ(makeCatalogue()->find("YogiBear")->parameters, bear->parameters);
}

TEST(Catalogue, AUsersFileAddsAndReplaces) {
    const auto catalogue = makeCatalogue(
        file(
            R"({"id": 0, "name": "Bumper", "parameters": [{"name": "hit", "type": "bool", "access": "read"}]},
                {"id": 200, "name": "Lamp", "parameters": [
                    {"name": "level", "type": "uint8", "access": "write", "lowest": 0, "highest": 100, "unit": "%"}]},
                {"id": 201, "name": "Twin", "like": "Lamp"})"),
        "mine.json");
    ASSERT_TRUE(catalogue) << catalogue.error().detail;
    EXPECT_EQ(catalogue->find(0)->name, "Bumper");
    EXPECT_EQ(catalogue->find("LimitSwitch"), nullptr);
    EXPECT_EQ(catalogue->find(200)->parameters[0].unit, "%");
    EXPECT_EQ(catalogue->find(201)->parameters, catalogue->find(200)->parameters);
    EXPECT_EQ(catalogue->find(12)->name, "PolarBear");
}

TEST(Catalogue, AFileThatIsNoneSaysWhatIsWrongWhere) {
    EXPECT_EQ(refusal(""), "it is not JSON");
    EXPECT_EQ(refusal("{"), "it is not JSON");
    EXPECT_EQ(refusal(std::string(100'000, '[')), "it is not JSON");
    EXPECT_EQ(refusal("[]"), "it does not say \"format\": \"kickstand-smart-devices\"");
    EXPECT_EQ(refusal(R"({"format": "kickstand-smart-devices", "version": 2, "devices": []})"),
              "its version is another one");
    EXPECT_EQ(refusal(R"({"format": "kickstand-smart-devices", "version": 1})"), "it has no list of devices");
    EXPECT_EQ(refusal(file("7")), "device 1: it is not an object");
    EXPECT_EQ(refusal(file(R"({"id": -1, "name": "A"})")),
              "device 1: its id is not a number from 0 to 65535");
    EXPECT_EQ(refusal(file(R"({"id": 70000, "name": "A"})")),
              "device 1: its id is not a number from 0 to 65535");
    EXPECT_EQ(refusal(file(R"({"id": 1, "name": "a b"})")),
              "device 1: it has no name of 1 to 64 characters without spaces");
    EXPECT_EQ(refusal(file(R"({"id": 1, "name": "A"})")),
              "A: it has parameters, or it is reserved, or like another: one of the three");
    EXPECT_EQ(refusal(file(R"({"id": 1, "name": "A", "colour": 1})")), "A: \"colour\" means nothing here");
    EXPECT_EQ(refusal(file(R"({"id": 1, "name": "A", "like": "B"})")),
              "device 1: there is no device named B to be like");
    EXPECT_EQ(refusal(file(R"({"id": 1, "name": "A", "like": "A"})")),
              "device 1: there is no device named A to be like");
    EXPECT_EQ(refusal(file(
                  R"({"id": 1, "name": "A", "reserved": true}, {"id": 2, "name": "A", "reserved": true})")),
              "A: there is another device of that name");
    EXPECT_EQ(refusal(device("")), "Thing: its parameters are not a list of 1 to 16");
    EXPECT_EQ(refusal(device(R"({"name": "p", "type": "int", "access": "read"})")),
              "Thing, parameter 0: its type is none of the protocol's");
    EXPECT_EQ(refusal(device(R"({"name": "p", "type": "bool", "access": "all"})")),
              "Thing, parameter 0: its access is not read, write or read-write");
    EXPECT_EQ(refusal(device(R"({"name": "p", "type": "uint8", "access": "read", "highest": 256})")),
              "Thing, parameter 0: highest is not a value of its type");
    EXPECT_EQ(
        refusal(device(R"({"name": "p", "type": "int8", "access": "read", "lowest": 2, "highest": 1})")),
        "Thing, parameter 0: lowest is above highest");
    EXPECT_EQ(refusal(device(R"({"name": "p", "type": "bool", "access": "read", "stop": "zero"})")),
              "Thing, parameter 0: stop can only be \"zero\", of what can be written");
    EXPECT_EQ(refusal(device(R"({"name": "p", "type": "bool", "access": "read"},
                                {"name": "p", "type": "bool", "access": "read"})")),
              "Thing, parameter 1: there is another parameter of that name");
}

}  // namespace
}  // namespace kickstand::smartdevice
