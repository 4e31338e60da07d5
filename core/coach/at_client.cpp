#include "core/coach/at_client.h"

#include <charconv>
#include <utility>

namespace kickstand::coach {
namespace {

/// A little more than the second that a module wants around +++.
constexpr Duration kGuard = std::chrono::milliseconds(1100);
constexpr Duration kEnterLimit = std::chrono::milliseconds(1600);
/// The slowest line needs 100 ms for a question and its answer; a module writing its memory somewhat longer.
constexpr Duration kFrameLimit = std::chrono::milliseconds(400);
constexpr Duration kTextLimit = std::chrono::seconds(1);
/// No answer is longer.
constexpr std::size_t kLongestLine = 64;
constexpr AtName kNodeName{'N', 'I'};

std::string hexText(const std::vector<std::uint8_t>& value) {
    std::string text;
    for (const std::uint8_t byte : value) {
        constexpr char kDigits[] = "0123456789ABCDEF";
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

Result<std::vector<std::uint8_t>> bytesOfHex(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (error != std::errc() || end != text.data() + text.size() || text.empty())
        return fail(Errc::Malformed, "radio", std::string(text));
    std::vector<std::uint8_t> bytes(8);
    storeBe32(bytes, 0, static_cast<std::uint32_t>(number >> 32));
    storeBe32(bytes, 4, static_cast<std::uint32_t>(number));
    return bytes;
}

std::string nameText(AtName name) {
    return {name[0], name[1]};
}

}  // namespace

AtClient::~AtClient() {
    scheduler_.cancel(timer_);
}

void AtClient::begin(Done done, Duration limit) {
    cancel();
    done_ = std::move(done);
    text_.clear();
    timer_ = scheduler_.callAfter(limit, [this] {
        timer_ = 0;
        finish(fail(Errc::TimedOut, "radio"));
    });
}

void AtClient::cancel() {
    scheduler_.cancel(std::exchange(timer_, 0));
    done_ = {};
}

void AtClient::finish(Result<std::vector<std::uint8_t>> result) {
    scheduler_.cancel(std::exchange(timer_, 0));
    auto done = std::exchange(done_, {});
    if (done) done(std::move(result));
}

void AtClient::enterCommandMode(Done done) {
    if (line_.mode() != ModuleMode::Transparent) {
        begin(std::move(done), Duration::zero());
        scheduler_.cancel(std::exchange(timer_, 0));
        timer_ = scheduler_.callAfter(Duration::zero(), [this] {
            timer_ = 0;
            finish(std::vector<std::uint8_t>());
        });
        return;
    }
    cancel();
    sets_ = true;
    timer_ = scheduler_.callAfter(kGuard, [this, done = std::move(done)]() mutable {
        timer_ = 0;
        begin(std::move(done), kEnterLimit);
        line_.sendText("+++");
    });
}

void AtClient::ask(AtName name, std::vector<std::uint8_t> value, Done done) {
    const bool frames = line_.mode() != ModuleMode::Transparent;
    begin(std::move(done), frames ? kFrameLimit : kTextLimit);
    name_ = name;
    const bool command = name == AtName{'W', 'R'} || name == AtName{'C', 'N'} || name == AtName{'A', 'C'};
    sets_ = command || !value.empty();
    if (frames) {
        frameId_ = line_.sendAt(name, value);
        return;
    }
    const std::string text = name == kNodeName ? std::string(value.begin(), value.end()) : hexText(value);
    line_.sendText("AT" + nameText(name) + text + "\r");
}

void AtClient::response(const xbee::AtResponse& response) {
    if (!done_ || response.frameId != frameId_ || response.name != name_) return;
    if (response.status != static_cast<std::uint8_t>(xbee::AtOutcome::Ok)) {
        finish(fail(Errc::BadArgument, nameText(name_), "status " + std::to_string(int{response.status})));
        return;
    }
    finish(std::vector<std::uint8_t>(response.value.begin(), response.value.end()));
}

void AtClient::text(ByteView bytes) {
    for (const std::uint8_t byte : bytes) {
        if (!done_) return;
        if (byte == '\r') {
            const std::string line = std::exchange(text_, {});
            lineCame(line);
        } else if (byte != '\n' && text_.size() < kLongestLine) {
            text_ += static_cast<char>(byte);
        }
    }
}

void AtClient::lineCame(std::string_view line) {
    if (line == "ERROR") {
        finish(fail(Errc::BadArgument, nameText(name_), "ERROR"));
    } else if (sets_) {
        // What came by radio before the module was in its command mode may stand before its OK.
        if (line.ends_with("OK")) finish(std::vector<std::uint8_t>());
    } else if (name_ == kNodeName) {
        finish(std::vector<std::uint8_t>(line.begin(), line.end()));
    } else {
        finish(bytesOfHex(line));
    }
}

}  // namespace kickstand::coach
