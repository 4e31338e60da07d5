#include "core/thunderbots/wire/firmware.h"

#include <numeric>

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

FillPageRequest fill(std::uint8_t offset, std::size_t count) {
    FillPageRequest request;
    request.offset = offset;
    request.data.resize(count);
    const ByteSpan data = request.data.span();
    std::iota(data.begin(), data.end(), std::uint8_t{1});
    return request;
}

OperationalParameters parameters() {
    return decodeParameters(hex("00 0e 0f 07 c0 00")).value();
}

struct RequestVector {
    FirmwareRequest request;
    const char* bytes;
};
const std::vector<RequestVector>& requests() {
    static const std::vector<RequestVector> all{
        {EraseChipRequest{}, "00"},
        {fill(0x40, 3), "01 40 01 02 03"},
        {ProgramPageRequest{0x1234, 0x6F91}, "02 34 12 91 6f"},
        {BlockCrcRequest{0x012345, 0x1000}, "03 45 23 01 00 10"},
        {BlockCrcRequest{0, kMaxCrcBlock}, "03 00 00 00 00 00"},
        {ReadParametersRequest{}, "04"},
        {SetParametersRequest{parameters()}, "05 00 0e 0f 07 c0 00"},
        {CommitParametersRequest{}, "07"},
        {RebootRequest{}, "08"},
        {ReadSignaturesRequest{}, "09"},
    };
    return all;
}

struct ResponseVector {
    FirmwareResponse response;
    const char* bytes;
};
const std::vector<ResponseVector>& responses() {
    static const std::vector<ResponseVector> all{
        {EraseChipResponse{}, "00"},
        {ProgramPageResponse{}, "02"},
        {BlockCrcResponse{0x012345, 0x1000, 0x6F91}, "03 45 23 01 00 10 91 6f"},
        {BlockCrcResponse{0x1F0000, kMaxCrcBlock, 1}, "03 00 00 1f 00 00 01 00"},
        {ReadParametersResponse{parameters()}, "04 00 0e 0f 07 c0 00"},
        {SetParametersResponse{}, "05"},
        {CommitParametersResponse{}, "07"},
        {RebootResponse{}, "08"},
        {ReadSignaturesResponse{0x1234, 0x5678}, "09 34 12 78 56"},
    };
    return all;
}

TEST(Firmware, EveryRequestBothWays) {
    for (const auto& [request, text] : requests()) {
        EXPECT_EQ(bytesOf(encodeFirmwareRequest(request).value()), hex(text));
        const auto decoded = decodeFirmwareRequest(hex(text));
        ASSERT_TRUE(decoded.has_value()) << text;
        EXPECT_TRUE(*decoded == request) << text;
        EXPECT_EQ(static_cast<int>(opOf(request)), hex(text)[0]);
    }
}

TEST(Firmware, EveryResponseBothWays) {
    for (const auto& [response, text] : responses()) {
        EXPECT_EQ(bytesOf(encodeFirmwareResponse(response).value()), hex(text));
        const auto decoded = decodeFirmwareResponse(hex(text));
        ASSERT_TRUE(decoded.has_value()) << text;
        EXPECT_TRUE(*decoded == response) << text;
        EXPECT_EQ(static_cast<int>(opOf(response)), hex(text)[0]);
    }
}

TEST(Firmware, UnknownOpcodesAreNamed) {
    for (int opcode = 0; opcode < 256; ++opcode) {
        Bytes payload(64 - 1);
        payload[0] = static_cast<std::uint8_t>(opcode);
        const bool exists = opcode <= 9 && opcode != 6;
        const auto request = decodeFirmwareRequest(payload);
        EXPECT_EQ(!request && request.error().fault == WireFault::UnknownKind, !exists) << opcode;
        const auto response = decodeFirmwareResponse(payload);
        EXPECT_EQ(!response && response.error().fault == WireFault::UnknownKind, !exists || opcode == 1)
            << opcode;
    }
}

TEST(Firmware, EveryCutOrLengthenedMessageOfFixedLengthIsRefused) {
    const auto isOpen = [](FirmwareOp op) {
        return op == FirmwareOp::FillPage || op == FirmwareOp::SetParameters;
    };
    for (const auto& [request, text] : requests()) {
        if (isOpen(opOf(request))) continue;
        Bytes payload = hex(text);
        payload.push_back(0);
        expectFault(decodeFirmwareRequest(payload), WireFault::TooLong, "length");
        payload.pop_back();
        payload.pop_back();
        expectFault(decodeFirmwareRequest(payload), WireFault::TooShort, "length");
    }
    for (const auto& [response, text] : responses()) {
        if (opOf(response) == FirmwareOp::ReadParameters) continue;
        Bytes payload = hex(text);
        payload.push_back(0);
        expectFault(decodeFirmwareResponse(payload), WireFault::TooLong, "length");
        payload.pop_back();
        payload.pop_back();
        expectFault(decodeFirmwareResponse(payload), WireFault::TooShort, "length");
    }
}

TEST(Firmware, FillStaysWithinTheMessageAndThePage) {
    EXPECT_EQ(encodeFirmwareRequest(fill(0, kMaxFillBytes)).value().size(), kMaxMessagePayload);
    EXPECT_TRUE(encodeFirmwareRequest(fill(195, 61)).has_value());
    const auto past = encodeFirmwareRequest(fill(196, 61));
    expectFault(past, WireFault::OutOfRange, "data");
    EXPECT_EQ(past.error().highest, 60);
    expectFault(encodeFirmwareRequest(fill(0, 0)), WireFault::OutOfRange, "data");
    expectFault(decodeFirmwareRequest(hex("01 ff 00 00")), WireFault::BadLength, "data");
    expectFault(decodeFirmwareRequest(hex("01 00")), WireFault::TooShort, "length");
    EXPECT_TRUE(decodeFirmwareRequest(hex("01 ff 00")).has_value());
    expectFault(decodeFirmwareRequest(Bytes(64, 1)), WireFault::TooLong, "length");
}

TEST(Firmware, BlocksStayWithinWhatTheFieldsHold) {
    expectFault(encodeFirmwareRequest(BlockCrcRequest{0, 0}), WireFault::OutOfRange, "length");
    expectFault(encodeFirmwareRequest(BlockCrcRequest{0, 65537}), WireFault::OutOfRange, "length");
    expectFault(encodeFirmwareRequest(BlockCrcRequest{0, 0xFFFFFFFF}), WireFault::OutOfRange, "length");
    expectFault(encodeFirmwareRequest(BlockCrcRequest{0x1000000, 1}), WireFault::OutOfRange, "address");
    expectFault(encodeFirmwareResponse(BlockCrcResponse{0xFFFFFFFF, 1, 0}), WireFault::OutOfRange, "address");
    EXPECT_TRUE(encodeFirmwareRequest(BlockCrcRequest{kMaxFlashAddress, 1}).has_value());
}

TEST(Firmware, ParametersAreCheckedOnlyWhereTheyWouldBeWritten) {
    const auto damaged = decodeFirmwareResponse(hex("04 00 ff ff ff ff"));
    ASSERT_TRUE(damaged.has_value()) << "a damaged block can be shown";
    EXPECT_TRUE(encodeFirmwareResponse(*damaged).has_value());
    const auto& shown = std::get<ReadParametersResponse>(*damaged).parameters;
    expectFault(encodeFirmwareRequest(SetParametersRequest{shown}), WireFault::OutOfRange, "channel0");
    expectFault(decodeFirmwareRequest(hex("05 00 0e 0f 07")), WireFault::TooShort, "length");
}

TEST(Firmware, OperationsAreNamedAndOnlyFillIsUnanswered) {
    EXPECT_STREQ(name(FirmwareOp::FillPage), "fill-page");
    EXPECT_STREQ(name(FirmwareOp::ReadSignatures), "signatures");
    EXPECT_STREQ(name(static_cast<FirmwareOp>(6)), "undefined");
    for (const auto& [request, text] : requests()) {
        EXPECT_EQ(isAnswered(opOf(request)), opOf(request) != FirmwareOp::FillPage) << text;
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
