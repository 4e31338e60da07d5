#include "core/thunderbots/sim/firmware_service.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "core/framing/crc16.h"

namespace kickstand::thunderbots::sim {
namespace {

constexpr Duration kEraseTime = std::chrono::seconds(8);
constexpr Duration kProgramTime = std::chrono::microseconds(1500);
constexpr Duration kCrcTimePerByte = std::chrono::microseconds(1);

}  // namespace

FirmwareService::FirmwareService(Scheduler& scheduler, FlashChip& flash, Microcontroller& controller,
                                 Respond respond)
    : flash_(flash), controller_(controller), respond_(std::move(respond)), busy_(scheduler) {}

void FirmwareService::reset() {
    busy_.stop();
    page_ = {};
}

void FirmwareService::handle(ByteView message) {
    const auto request = wire::decodeFirmwareRequest(message);
    if (!request || busy_.running()) {
        ++ignored_;
        return;
    }
    std::visit([this](const auto& one) { execute(one); }, *request);
}

void FirmwareService::execute(const wire::EraseChipRequest& /*request*/) {
    answerAfter(kEraseTime, [this]() -> wire::FirmwareResponse {
        flash_.erase();
        controller_.commitNoData();
        return wire::EraseChipResponse{};
    });
}

void FirmwareService::execute(const wire::FillPageRequest& request) {
    std::copy(request.data.begin(), request.data.end(), page_.begin() + request.offset);
}

void FirmwareService::execute(const wire::ProgramPageRequest& request) {
    if (request.page >= wire::kFlashPageCount) {
        ++ignored_;
        return;
    }
    if (crc16(page_) != request.crc) {
        ++wrongCrcs_;
        return;
    }
    answerAfter(kProgramTime, [this, page = request.page]() -> wire::FirmwareResponse {
        flash_.program(page, page_);
        return wire::ProgramPageResponse{};
    });
}

void FirmwareService::execute(const wire::BlockCrcRequest& request) {
    if (request.address + request.length > wire::kFlashBytes) {
        ++ignored_;
        return;
    }
    answerAfter(kCrcTimePerByte * request.length, [this, request]() -> wire::FirmwareResponse {
        return wire::BlockCrcResponse{.address = request.address,
                                      .length = request.length,
                                      .crc = flash_.crc(request.address, request.length)};
    });
}

void FirmwareService::execute(const wire::ReadParametersRequest& /*request*/) {
    answer(wire::ReadParametersResponse{.parameters = controller_.shadow()});
}

void FirmwareService::execute(const wire::SetParametersRequest& request) {
    // The robot has a block of one length; it does not guess at another.
    if (request.parameters.tail.size() != controller_.shadow().tail.size()) {
        ++ignored_;
        return;
    }
    controller_.setShadow(request.parameters);
    answer(wire::SetParametersResponse{});
}

void FirmwareService::execute(const wire::CommitParametersRequest& /*request*/) {
    controller_.commit();
    answer(wire::CommitParametersResponse{});
}

void FirmwareService::execute(const wire::RebootRequest& /*request*/) {
    answer(wire::RebootResponse{}, true);
}

void FirmwareService::execute(const wire::ReadSignaturesRequest& /*request*/) {
    answerAfter(kCrcTimePerByte * wire::kFlashBytes, [this]() -> wire::FirmwareResponse {
        return wire::ReadSignaturesResponse{.microcontrollerCrc = controller_.signature(),
                                            .flashCrc = flash_.crc(0, wire::kFlashBytes)};
    });
}

void FirmwareService::answer(const wire::FirmwareResponse& response, bool rebootAfterwards) {
    if (const auto bytes = wire::encodeFirmwareResponse(response)) respond_(*bytes, rebootAfterwards);
}

void FirmwareService::answerAfter(Duration time, std::function<wire::FirmwareResponse()> finish) {
    busy_.start(time, [this, finish = std::move(finish)] { answer(finish()); });
}

}  // namespace kickstand::thunderbots::sim
