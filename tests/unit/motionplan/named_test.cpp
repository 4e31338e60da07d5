#include "core/motionplan/wire/named.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/hex.h"

namespace kickstand::motionplan::wire {
namespace {

constexpr const char* kSample = "0d 00 80 09 07 09 00 09 04 0d 5c 12 7e 37 00";

std::string encoded(const char* name, const std::vector<NamedText>& fields) {
    const auto bytes = encodeNamed(name, fields);
    return bytes ? toHex(*bytes) : std::string("refused: ") + bytes.error().subject;
}

const NamedField* find(const std::vector<NamedField>& fields, std::string_view name) {
    const auto found = std::ranges::find(fields, name, &NamedField::name);
    return found == fields.end() ? nullptr : &*found;
}

TEST(Named, TheSampleIsTakenApartAndPutTogether) {
    const auto fields = decodeNamed("motionplan.telegram", *parseHex(kSample));
    ASSERT_TRUE(fields);
    EXPECT_EQ(find(*fields, "message")->label, "create");
    EXPECT_EQ(find(*fields, "plan")->value, 9);
    EXPECT_EQ(find(*fields, "slot")->value, 4);
    EXPECT_EQ(find(*fields, "movements")->label,
              "forward 25, turn right 84, forward 50, turn left back 90, back 100");
    EXPECT_EQ(encoded("motionplan.telegram.create",
                      {{"plan", "9"}, {"slot", "4"}, {"movements", "0d 5c 12 7e 37"}}),
              kSample);
    EXPECT_EQ(encoded("motionplan.telegram.create",
                      {{"plan", "9"},
                       {"slot", "4"},
                       {"movements", "forward 25, turn right 84, forward 50, turn left back 90, back 100"}}),
              kSample);
}

TEST(Named, EveryNameWritesWhatItReads) {
    for (const NamedSpec& spec : namedTelegrams()) {
        std::vector<NamedText> fields;
        for (const std::string& field : spec.fields) {
            if (field == "movements") fields.emplace_back(field, "forward 25");
            if (field == "content") fields.emplace_back(field, "77 01");
            if (field == "plan") fields.emplace_back(field, "9");
        }
        const auto bytes = encodeNamed(spec.name, fields);
        ASSERT_TRUE(bytes) << spec.name;
        const auto decoded = decodeNamed(spec.name, *bytes);
        ASSERT_TRUE(decoded) << spec.name;
        for (const std::string& field : spec.fields)
            EXPECT_NE(find(*decoded, field), nullptr) << spec.name << ' ' << field;
        EXPECT_EQ(decodeNamed("motionplan.telegram", *bytes)->size(), decoded->size());
    }
}

TEST(Named, ReadsAReplyDownToTheMessageInIt) {
    auto reply =
        *encodeNamed("motionplan.telegram.read-reply", std::vector<NamedText>{{"content", "07 04 00"}});
    const auto fields = decodeNamed("motionplan.telegram", reply);
    ASSERT_TRUE(fields);
    EXPECT_EQ(find(*fields, "error")->value, 4);
    EXPECT_EQ(find(*fields, "error")->label, "the plan in that slot has another ID, so it was not executed");
    EXPECT_EQ(find(*fields, "status")->label, "done");
}

TEST(Named, LabelsAndSignedNumbersAreTaken) {
    EXPECT_EQ(encoded("motionplan.telegram.adjust",
                      {{"plan", "0x09"}, {"slot", "4"}, {"wheels", "right-back"}, {"change", "-30"}}),
              "0a 00 80 09 07 06 06 09 04 05 e2 00");
}

TEST(Named, WhatIsWrongIsNamed) {
    EXPECT_EQ(encodeNamed("motionplan.telegram.sing", {}).error().code, Errc::UnknownName);
    EXPECT_EQ(encoded("motionplan.telegram.execute", {{"plan", "9"}, {"speed", "1"}}), "refused: speed");
    EXPECT_EQ(encoded("motionplan.telegram.execute", {{"plan", "9"}, {"plan", "8"}}), "refused: plan");
    EXPECT_EQ(encoded("motionplan.telegram.execute", {{"plan", "9"}, {"slot", "5"}}), "refused: slot");
    EXPECT_EQ(encoded("motionplan.telegram.execute", {{"plan", "nine"}}), "refused: plan");
    EXPECT_EQ(encoded("motionplan.telegram.execute", {}), "refused: plan");
    EXPECT_EQ(encoded("motionplan.telegram.create", {{"plan", "9"}}), "refused: movements");
    EXPECT_EQ(encoded("motionplan.telegram.create", {{"plan", "9"}, {"movements", "forward 38"}}),
              "refused: distance");
    EXPECT_EQ(decodeNamed("motionplan.telegram.stop", *parseHex(kSample)).error().code, Errc::Malformed);
    EXPECT_EQ(decodeNamed("nothing", {}).error().code, Errc::UnknownName);
}

}  // namespace
}  // namespace kickstand::motionplan::wire
