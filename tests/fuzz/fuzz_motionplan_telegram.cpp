// Whatever comes from a robot: as one telegram, as a stream in two pieces, and as what a mailbox held.
#include "core/motionplan/wire/message.h"
#include "core/motionplan/wire/named.h"
#include "core/motionplan/wire/telegram.h"
#include "core/motionplan/wire/telegram_parser.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::motionplan::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    if (const auto telegram = decodeTelegram(input)) {
        const auto bytes = encodeTelegram(*telegram);
        fuzz::require(bytes.has_value(), "what was read can be written");
        fuzz::require(*decodeTelegram(bytes->view()) == *telegram, "what was written reads as the same");
        fuzz::require(telegramSize(input) == size, "the size of a telegram is known from its beginning");
        fuzz::require(decodeNamed("motionplan.telegram", input).has_value(), "it has a name");
    }
    fuzz::requireEcho(input, decodeMessage, encodeMessage);
    fuzz::require(withoutTerminator(input).size() + 1 >= size, "at most one byte is a terminator");

    TelegramParser parser;
    std::uint64_t carried = 0;
    const auto take = [&carried](const Telegram& telegram) {
        carried += encodeTelegram(telegram).has_value() ? 1 : 0;
    };
    parser.feed(input.first(size / 2), take);
    parser.feed(input.subspan(size / 2), take);
    parser.abandon();
    fuzz::require(carried == parser.counters().telegrams, "every telegram that was found can be written");
    fuzz::require(parser.counters().skipped <= size, "no byte is skipped twice");
    return 0;
}
