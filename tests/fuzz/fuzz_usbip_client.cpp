#include "core/base/fake_scheduler.h"
#include "core/link/usbip/usbip_client.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/fuzz_usbip.h"

using namespace kickstand;
using namespace kickstand::usbip;

namespace {

void parseAll(ByteView input) {
    OpStatus status{};
    std::vector<Device> devices;
    if (fuzz::parsed(input, parseDeviceList(input, status, devices)) && status == OpStatus::Ok) {
        std::vector<Device> again;
        parseDeviceList(encodeDeviceList(devices), status, again);
        fuzz::require(again == devices, "a list that was read can be written and reads as the same");
    }
    Device device;
    fuzz::parsed(input, parseImportReply(input, status, device));
    Reply reply;
    if (fuzz::parsed(input, parseReply(input, reply)))
        fuzz::require(reply.actual <= kMaxTransferBytes, "an answer is bounded");
}

/// A server that says what it was given to say, all at once.
class Script final : public ByteStream {
  public:
    void start(Events events) override { events_ = std::move(events); }
    void send(ByteView) override {}
    std::size_t unsent() const override { return 0; }
    void close() override { closed_ = true; }

    void say(ByteView bytes) {
        const auto events = events_;
        if (!closed_) events.received(bytes);
    }

  private:
    Events events_;
    bool closed_ = false;
};

/// A client that has imported a device and waits for some transfers hears `input`, in two pieces.
void converse(ByteView input) {
    FakeScheduler scheduler;
    auto stream = std::make_unique<Script>();
    Script& server = *stream;
    UsbipClient client(scheduler, std::move(stream));
    int lost = 0;
    client.import(
        "1-1", [](const auto&) {}, [&](const Error&) { ++lost; });
    server.say(encodeImportReply(OpStatus::Ok, {}));
    constexpr int kTransfers = 12;
    int ended = 0;
    for (int i = 0; i < kTransfers; ++i) {
        const auto done = [&](const UsbCompletion& completion) {
            ++ended;
            fuzz::require(completion.data.size() <= 64, "no more comes than was asked for");
        };
        const auto sequence =
            i % 2 ? client.in(0x85, 64, 1, done) : client.out(0x05, input.first(0), 1, done);
        if (i % 3 == 0) client.unlink(sequence);
    }
    const std::size_t half = input.size() / 2;
    server.say(input.first(half));
    server.say(input.subspan(half));
    scheduler.advance(std::chrono::seconds(10));
    fuzz::require(ended == kTransfers, "every transfer ends once");
    fuzz::require(lost <= 1, "what is lost is lost once");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    parseAll(input);
    converse(input);
    return 0;
}
