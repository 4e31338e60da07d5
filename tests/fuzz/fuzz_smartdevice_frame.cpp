#include "core/smartdevice/wire/frame.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::smartdevice::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    for (const Dialect dialect : {Dialect::Current, Dialect::Hibike}) {
        if (const auto message = decodeMessage(dialect, input)) {
            const MessageBytes bytes = encodeMessage(dialect, *message);
            fuzz::require(fuzz::sameBytes(bytes.view(), input), "what was read is written the same");
        }
        Decoder decoder(dialect);
        decoder.feed(input, [&](const Message& message) {
            const FrameBytes frame = encodeFrame(dialect, message);
            Decoder again(dialect);
            bool same = false;
            again.feed(frame.view(), [&](const Message& read) { same = read == message; });
            fuzz::require(same, "what came out goes in again");
        });
        fuzz::require(decoder.counts().dropped <= size, "no more is dropped than came");
        // Whatever came before, after a zero and a whole frame it is in step.
        const std::uint8_t zero = 0;
        decoder.feed({&zero, 1}, [](const Message&) {});
        int heard = 0;
        for (int i = 0; i < 2; ++i)
            decoder.feed(encodeFrame(dialect, Ping{}).view(), [&](const Message&) { ++heard; });
        fuzz::require(heard >= 1, "it is back in step");
    }
    return 0;
}
