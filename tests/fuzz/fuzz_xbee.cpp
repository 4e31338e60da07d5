#include <vector>

#include "core/coach/wire/message.h"
#include "core/framing/xbee_parser.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;

namespace {

using Frames = std::vector<std::vector<std::uint8_t>>;

Frames parse(xbee::Parser& parser, ByteView input, std::size_t piece) {
    Frames frames;
    for (std::size_t at = 0; at < input.size(); at += piece) {
        ByteView part = input.subspan(at, std::min(piece, input.size() - at));
        for (ByteView data = parser.next(part); !data.empty(); data = parser.next(part))
            frames.emplace_back(data.begin(), data.end());
        fuzz::require(part.empty(), "all bytes were taken");
    }
    return frames;
}

void checkFrame(ByteView data) {
    const auto frame = xbee::decodeFrame(data);
    if (!frame) return;
    // A packet may hold more than this program sends.
    const xbee::FrameData again = xbee::encodeFrame(*frame);
    fuzz::require(again.empty() || fuzz::sameBytes(again.view(), data), "a frame comes back as it was");
    const auto* rx = std::get_if<xbee::Rx16>(&*frame);
    if (rx == nullptr) return;
    const auto message = coach::wire::decodeMessage(rx->payload);
    if (message)
        fuzz::require(fuzz::sameBytes(coach::wire::encodeMessage(*message), rx->payload), "a message too");
}

}  // namespace

/// The first byte chooses the mode and the size of the pieces.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto mode = (data[0] & 1) != 0 ? xbee::ApiMode::Escaped : xbee::ApiMode::Plain;
    const ByteView input{data + 1, size - 1};
    xbee::Parser whole(mode);
    xbee::Parser pieces(mode);
    const Frames frames = parse(whole, input, size);
    fuzz::require(parse(pieces, input, 1 + (data[0] >> 1)) == frames, "pieces make no difference");
    fuzz::require(pieces.counters() == whole.counters(), "nor to what is counted");
    fuzz::require(whole.counters().frames == frames.size(), "every frame is counted");
    for (const auto& frame : frames)
        checkFrame(frame);
    return 0;
}
