#include "core/motionplan/wire/message.h"

#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan::wire {
namespace {

std::string hexOf(const Message& message) {
    const auto bytes = encodeMessage(message);
    return bytes ? toHex(bytes->view()) : std::string("refused: ") + bytes.error().subject;
}

Result<Message> read(const char* hex) {
    return decodeMessage(*parseHex(hex));
}

Message message(MessageKind kind, int plan = 0, int slot = 0) {
    Message made;
    made.kind = kind;
    made.plan = plan;
    made.slot = slot;
    return made;
}

TEST(Message, EachKindHasItsBytes) {
    Message create = message(MessageKind::Create, 9, 4);
    create.movements = {0x0D, 0x5C, 0x12, 0x7E, 0x37};
    EXPECT_EQ(hexOf(create), "00 09 04 0d 5c 12 7e 37");
    EXPECT_EQ(hexOf(message(MessageKind::Stop)), "01");
    create.kind = MessageKind::Update;
    EXPECT_EQ(hexOf(create), "02 09 04 0d 5c 12 7e 37");
    EXPECT_EQ(hexOf(message(MessageKind::Execute, 254, 0)), "03 fe 00");
    Message status = message(MessageKind::Status, 9, 4);
    status.step = 55;
    EXPECT_EQ(hexOf(status), "04 09 04 37");
    EXPECT_EQ(hexOf(message(MessageKind::Query, kDummyPlan, 3)), "05 ff 03");
    Message adjust = message(MessageKind::Adjust, 9, 4);
    adjust.wheels = Wheels::RightBack;
    adjust.change_percent = -100;
    EXPECT_EQ(hexOf(adjust), "06 09 04 05 9c");
    Message error = message(MessageKind::Error);
    error.error = 7;
    EXPECT_EQ(hexOf(error), "07 07");
    create.kind = MessageKind::Trigger;
    EXPECT_EQ(hexOf(create), "08 09 0d 5c 12 7e 37");
}

TEST(Message, EveryKindComesBack) {
    for (const MessageSpec& spec : messageSpecs()) {
        Message sent = message(spec.kind, 17, 2);
        for (const FieldSpec& field : spec.fields)
            sent.setValue(field.id, field.highest);
        sent.movements.assign(3, 0x0D);
        const auto bytes = encodeMessage(sent);
        ASSERT_TRUE(bytes) << name(spec.kind);
        const auto back = decodeMessage(bytes->view());
        ASSERT_TRUE(back) << name(spec.kind);
        EXPECT_EQ(*encodeMessage(*back), *bytes) << name(spec.kind);
        for (const FieldSpec& field : spec.fields)
            EXPECT_EQ(back->value(field.id), sent.value(field.id)) << field.name;
    }
}

TEST(Message, TheLongestPlansFillTheMailbox) {
    Message create = message(MessageKind::Create, 1, 0);
    create.movements.assign(kMostMovements, 0x01);
    EXPECT_EQ(encodeMessage(create)->size(), kMostMessageBytes);
    create.movements.push_back(0x01);
    EXPECT_EQ(hexOf(create), "refused: movements");
    create.kind = MessageKind::Trigger;
    EXPECT_EQ(encodeMessage(create)->size(), kMostMessageBytes);
    create.movements.push_back(0x01);
    EXPECT_EQ(hexOf(create), "refused: movements");
    create.movements.clear();
    EXPECT_EQ(hexOf(create), "refused: movements");
}

TEST(Message, WhatIsOutOfRangeIsNotWritten) {
    EXPECT_EQ(hexOf(message(MessageKind::Execute, 0, 0)), "refused: plan");
    EXPECT_EQ(hexOf(message(MessageKind::Execute, 255, 0)), "refused: plan");
    EXPECT_EQ(hexOf(message(MessageKind::Execute, 1, 5)), "refused: slot");
    Message adjust = message(MessageKind::Adjust, 1, 0);
    adjust.change_percent = 101;
    EXPECT_EQ(hexOf(adjust), "refused: change");
    Message create = message(MessageKind::Create, 1, 0);
    create.movements = {0xC1};
    EXPECT_EQ(hexOf(create), "refused: movement");
}

TEST(Message, DamagedBytesSayWhatIsWrong) {
    EXPECT_EQ(read("").error().subject, "length");
    EXPECT_EQ(read("09").error().subject, "command");
    EXPECT_EQ(read("03 01").error().subject, "length");
    EXPECT_EQ(read("01 01").error().subject, "length");
    EXPECT_EQ(read("03 01 05").error().subject, "slot");
    EXPECT_EQ(read("06 01 00 06 00").error().subject, "wheels");
    EXPECT_EQ(read("06 01 00 00 65").error().subject, "change");
    EXPECT_EQ(read("00 01 00 ff").error().subject, "movement");
}

TEST(Terminator, IsTakenOffOnce) {
    const auto cut = [](const char* hex) { return toHex(withoutTerminator(*parseHex(hex))); };
    EXPECT_EQ(cut("03 09 04 00"), "03 09 04");
    EXPECT_EQ(cut("00 09 00 0d 00"), "00 09 00 0d");
    EXPECT_EQ(cut("04 09 04 00 00"), "04 09 04 00");
    EXPECT_EQ(cut(""), "");
    EXPECT_EQ(cut("00"), "");
}

TEST(Terminator, AZeroThatTheMessageNeedsIsNone) {
    const auto cut = [](const char* hex) { return toHex(withoutTerminator(*parseHex(hex))); };
    EXPECT_EQ(cut("03 09 00"), "03 09 00");
    EXPECT_EQ(cut("04 09 04 00"), "04 09 04 00");
    EXPECT_EQ(cut("07 00"), "07 00");
    EXPECT_EQ(cut("06 09 00 00 00"), "06 09 00 00 00");
    // A message that may be longer says nothing about where it ends.
    EXPECT_EQ(cut("08 07 00"), "08 07");
    EXPECT_EQ(cut("02 09 01 00"), "02 09 01");
}

TEST(ZeroBytes, AreFoundWhereTheyStand) {
    EXPECT_EQ(zeroBytes(*parseHex("00 09 04 0d")), (std::vector<std::size_t>{0}));
    EXPECT_EQ(zeroBytes(*parseHex("00 09 00 00")), (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_TRUE(zeroBytes(*parseHex("05 ff 04")).empty());
}

TEST(ErrorCodes, EachHasItsCommandAndATextOfItsOwn) {
    ASSERT_EQ(errorCodes().size(), 8U);
    for (int code = 0; code < kErrorCodes; ++code) {
        EXPECT_EQ(errorCodes()[static_cast<std::size_t>(code)].code, code);
        EXPECT_NE(errorCode(code).about, MessageKind::Error);
    }
    EXPECT_EQ(errorCode(kErrorStopIdle).about, MessageKind::Stop);
    EXPECT_STREQ(errorCode(8).id, "unknown");
    EXPECT_EQ(errorCode(200).code, 200);
}

TEST(NxtStatus, KnownOnesHaveNamesAndUnknownOnesKeepTheirNumber) {
    EXPECT_EQ(nxtStatuses().size(), 18U);
    EXPECT_STREQ(nxtStatus(kStatusMailboxEmpty).id, "mailbox-empty");
    EXPECT_STREQ(nxtStatus(0xEC).id, "no-program");
    EXPECT_STREQ(nxtStatus(0x33).id, "unknown");
    EXPECT_EQ(nxtStatus(0x33).code, 0x33);
}

}  // namespace
}  // namespace kickstand::motionplan::wire
