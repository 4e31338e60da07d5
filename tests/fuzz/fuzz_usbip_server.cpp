#include "core/link/usbip/usbip_wire.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/fuzz_usbip.h"

using namespace kickstand;
using namespace kickstand::usbip;

// What a server reads: requests, and commands one after the other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    Request request;
    if (fuzz::parsed(input, parseRequest(input, request))) {
        Request again;
        fuzz::require(parseRequest(encodeRequest(request), again).status == Parse::Status::Complete,
                      "a request that was read can be written");
        fuzz::require(again.kind == request.kind && again.busId == request.busId, "and reads as the same");
    }
    for (ByteView rest = input;;) {
        Command command;
        const Parse parse = parseCommand(rest, command);
        if (!fuzz::parsed(rest, parse)) break;
        fuzz::require(command.length <= kMaxTransferBytes, "a transfer is bounded");
        fuzz::require(isInEndpoint(command.endpoint) || command.kind == Command::Kind::Unlink ||
                          command.data.size() == command.length,
                      "all that is to be sent is there");
        Command again;
        const auto written = encodeCommand(command);
        fuzz::require(written.size() == parse.bytes, "what was written is as long as what was read");
        fuzz::require(parseCommand(written, again).bytes == parse.bytes, "and reads as long");
        fuzz::require(again.setup == command.setup && again.endpoint == command.endpoint, "and as the same");
        rest = rest.subspan(parse.bytes);
    }
    return 0;
}
