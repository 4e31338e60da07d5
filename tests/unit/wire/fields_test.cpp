#include "core/thunderbots/wire/fields.h"

#include <set>
#include <string>

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

bool hasPlace(const FieldSpec& field) {
    return field.kind != FieldKind::Bytes;
}

TEST(FieldTables, NamesAreUniqueAndEverythingIsDescribed) {
    std::set<std::string> names;
    for (const MessageSpec& message : messages()) {
        EXPECT_TRUE(names.insert(message.name).second) << message.name;
        EXPECT_TRUE(std::string_view(message.name).starts_with("thunderbots.")) << message.name;
        EXPECT_STRNE(message.summary, "") << message.name;
        EXPECT_STRNE(message.section, "") << message.name;
        ASSERT_NE(message.mayBeRead, nullptr) << message.name;
        ASSERT_NE(message.mayBeSent, nullptr) << message.name;
        std::set<std::string> fields;
        for (const FieldSpec& field : message.fields) {
            EXPECT_TRUE(fields.insert(field.name).second) << message.name << ' ' << field.name;
            EXPECT_STRNE(field.description, "") << message.name << ' ' << field.name;
        }
    }
}

TEST(FieldTables, EveryBitOfEveryMessageBelongsToExactlyOneField) {
    for (const MessageSpec& message : messages()) {
        std::multiset<int> bits;
        std::size_t end = std::size_t{message.minBytes} * 8;
        for (const FieldSpec& field : message.fields) {
            if (!hasPlace(field)) end = field.firstBit;
            for (int bit = 0; bit < field.width; ++bit)
                bits.insert(field.firstBit + bit);
        }
        EXPECT_EQ(bits.size(), end) << message.name;
        for (std::size_t bit = 0; bit < end; ++bit) {
            EXPECT_EQ(bits.count(static_cast<int>(bit)), 1U) << message.name << " bit " << bit;
        }
    }
}

TEST(FieldTables, RangesFitTheirBitsAndLabelsTheirRange) {
    for (const MessageSpec& message : messages()) {
        for (const FieldSpec& field : message.fields) {
            EXPECT_LE(field.lowest, field.highest) << message.name << ' ' << field.name;
            if (!hasPlace(field)) continue;
            const bool isSigned = field.kind == FieldKind::Signed;
            const std::int64_t top = std::int64_t{1} << (field.width - (isSigned ? 1 : 0));
            EXPECT_GE(field.lowest, isSigned ? -top : 0) << message.name << ' ' << field.name;
            EXPECT_LT(field.highest, top) << message.name << ' ' << field.name;
            EXPECT_LE(field.labels.size(), static_cast<std::size_t>(field.highest) + 1);
        }
    }
}

TEST(FieldTables, TheRestOfAMessageStandsLastAndFillsItsLength) {
    for (const MessageSpec& message : messages()) {
        for (const FieldSpec& field : message.fields) {
            if (hasPlace(field)) continue;
            EXPECT_EQ(&field, &message.fields.back()) << message.name;
            EXPECT_EQ(field.firstBit % 8, 0) << message.name;
            EXPECT_EQ(field.firstBit / 8 + field.lowest, message.minBytes) << message.name;
            EXPECT_EQ(field.firstBit / 8 + field.highest, message.maxBytes) << message.name;
        }
    }
}

TEST(FieldTables, DriveFieldsHaveTheNamesThatScriptsUse) {
    std::string names;
    for (const FieldSpec& field : findMessage("thunderbots.drive")->fields) {
        if (field.kind != FieldKind::Reserved) names += std::string(field.name) + ' ';
    }
    EXPECT_EQ(
        names,
        "run charge dribble mask1 mask2 armed wheel1 wheel2 wheel3 wheel4 test_class test_target t1 t2 dt ");
}

TEST(FieldTables, DriveBlocksReadThroughTheTableAreWhatTheDecoderGives) {
    const MessageSpec& drive = *findMessage("thunderbots.drive");
    std::mt19937 random(8);
    for (int i = 0; i < 5'000; ++i) {
        const DriveBlock block = randomDrive(random);
        const Bytes bytes = bytesOf(encodeDrive(block).value());
        const std::vector<std::int32_t> expected{block.run,
                                                 block.charge,
                                                 block.dribble,
                                                 block.autokick.flag1,
                                                 block.autokick.flag2,
                                                 block.autokickArmed,
                                                 0,
                                                 block.wheels[0],
                                                 block.wheels[1],
                                                 block.wheels[2],
                                                 block.wheels[3],
                                                 block.testClass,
                                                 block.testTarget,
                                                 block.autokick.t1,
                                                 block.autokick.t2,
                                                 block.autokick.dt,
                                                 0};
        ASSERT_EQ(drive.fields.size(), expected.size());
        Bytes rewritten(kDriveBytes);
        for (std::size_t f = 0; f < expected.size(); ++f) {
            ASSERT_EQ(readField(drive, drive.fields[f], bytes), expected[f]) << drive.fields[f].name;
            writeField(drive, drive.fields[f], rewritten, expected[f]);
        }
        ASSERT_EQ(rewritten, bytes);
    }
}

TEST(FieldTables, FamiliesLeadToTheVariantOfTheirOpcode) {
    EXPECT_STREQ(findMessageFor("thunderbots.firmware-request", hex("02 00 00 00 00"))->name,
                 "thunderbots.firmware-request.program-page");
    EXPECT_STREQ(findMessageFor("thunderbots.firmware-response", hex("09"))->name,
                 "thunderbots.firmware-response.signatures");
    EXPECT_EQ(findMessageFor("thunderbots.firmware-request", hex("06")), nullptr);
    EXPECT_EQ(findMessageFor("thunderbots.firmware-response", hex("01")), nullptr);
    EXPECT_EQ(findMessageFor("thunderbots.firmware-request", {}), nullptr);
    EXPECT_EQ(findMessageFor("thunderbots", hex("02")), nullptr);
    EXPECT_STREQ(findMessageFor("thunderbots.kick", {})->name, "thunderbots.kick");
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
