#include "core/motionplan/wire/plan_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

namespace kickstand::motionplan::wire {
namespace {

constexpr int kMostAmount = 100000;
constexpr int kCm_per_m = 100;
constexpr std::size_t kMostShown = 40;
constexpr std::array<const char*, kWheelsCount> kPhrases{"forward",        "back",      "turn right",
                                                         "turn left back", "turn left", "turn right back"};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isBreak(char c) {
    return c == ',' || c == ';' || c == '\n';
}

/// Reads one word after another. A number and the unit that touches it are two words.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) { skip(); }

    bool atEnd() const { return at_ == text_.size(); }
    bool atBreak() const { return !atEnd() && isBreak(text_[at_]); }
    std::size_t place() const { return at_; }
    void passBreak() {
        ++at_;
        skip();
    }
    /// The next word, not taken; empty at a break and at the end.
    std::string_view peek() const {
        std::size_t end = at_;
        const bool number = end < text_.size() && isDigit(text_[end]);
        while (end < text_.size() && !isBreak(text_[end]) && !isSpace(text_[end]) && text_[end] != '#' &&
               (!number || isDigit(text_[end])))
            ++end;
        return text_.substr(at_, end - at_);
    }
    void take() {
        at_ += peek().size();
        skip();
    }
    bool takeIf(std::string_view word) {
        const std::string_view next = peek();
        const bool same = std::ranges::equal(next, word, {}, lower);
        if (same) take();
        return same;
    }

  private:
    void skip() {
        while (at_ < text_.size() && isSpace(text_[at_]))
            ++at_;
        if (at_ == text_.size() || text_[at_] != '#') return;
        at_ = std::min(text_.find('\n', at_), text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

tl::unexpected<Error> unreadable(const Words& words, const char* expected) {
    std::string shown(words.peek().substr(0, kMostShown));
    if (shown.empty()) shown = words.atEnd() ? "the end" : "nothing";
    return fail({.code = Errc::Malformed,
                 .subject = expected,
                 .got = static_cast<std::int64_t>(words.place()),
                 .detail = std::move(shown)});
}

std::optional<Wheels> takeWheels(Words& words) {
    if (words.takeIf("forward") || words.takeIf("ahead")) return Wheels::BothForward;
    if (words.takeIf("back") || words.takeIf("backward")) return Wheels::BothBack;
    if (!words.takeIf("turn")) return std::nullopt;
    const bool left = words.takeIf("left");
    if (!left && !words.takeIf("right")) return std::nullopt;
    if (words.takeIf("back") || words.takeIf("backward")) return left ? Wheels::LeftBack : Wheels::RightBack;
    words.takeIf("forward");
    return left ? Wheels::RightForward : Wheels::LeftForward;
}

Result<int> takeAmount(Words& words, Wheels wheels) {
    const char* const expected = isTurn(wheels) ? "a number of degrees" : "a number of centimetres";
    const std::string_view digits = words.peek();
    if (digits.empty() || !isDigit(digits[0])) return unreadable(words, expected);
    std::int64_t amount = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), amount);
    // One that no number holds, in metres too, is shown as it was written.
    const bool huge = error != std::errc{} || amount > std::numeric_limits<std::int64_t>::max() / kCm_per_m;
    words.take();
    if (isTurn(wheels)) {
        for (const char* const unit : {"degrees", "deg", "\u00b0"}) {
            if (words.takeIf(unit)) break;
        }
    } else if (!words.takeIf("cm") && words.takeIf("m")) {
        amount = huge ? amount : amount * kCm_per_m;
    }
    if (!huge && amount >= 1 && amount <= kMostAmount) return static_cast<int>(amount);
    Error tooFar{.code = Errc::OutOfRange,
                 .subject = isTurn(wheels) ? "angle" : "distance",
                 .lowest = 1,
                 .highest = kMostAmount};
    if (huge)
        tooFar.detail = digits.substr(0, kMostShown);
    else
        tooFar.got = amount;
    return fail(std::move(tooFar));
}

tl::unexpected<Error> tooMuch(const char* what, std::size_t most, std::size_t got) {
    return fail({.code = Errc::OutOfRange,
                 .subject = what,
                 .lowest = 1,
                 .highest = static_cast<std::int64_t>(most),
                 .got = static_cast<std::int64_t>(got)});
}

}  // namespace

std::string toText(const Movement& movement) {
    const auto index = static_cast<std::size_t>(movement.wheels);
    return std::string(index < kPhrases.size() ? kPhrases[index] : "nothing") + ' ' +
           std::to_string(movement.amount);
}

std::string toText(std::span<const Movement> movements) {
    std::string text;
    for (const Movement& movement : movements)
        text += (text.empty() ? "" : ", ") + toText(movement);
    return text;
}

Result<std::vector<Movement>> parsePlanText(std::string_view text) {
    if (text.size() > kMostPlanTextBytes)
        return tooMuch("length of the text", kMostPlanTextBytes, text.size());
    // Some editors begin a file with the mark of its encoding.
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
    std::vector<Movement> movements;
    Words words(text);
    while (!words.atEnd()) {
        if (words.atBreak()) {
            words.passBreak();
            continue;
        }
        const auto wheels = takeWheels(words);
        if (!wheels) return unreadable(words, "a movement (forward, back, turn left, turn right)");
        const auto amount = takeAmount(words, *wheels);
        if (!amount) return fail(amount.error());
        if (!words.atEnd() && !words.atBreak()) return unreadable(words, "the end of the movement");
        movements.push_back({*wheels, *amount});
        if (movements.size() > kMostPlanSteps)
            return tooMuch("number of movements", kMostPlanSteps, movements.size());
    }
    return movements;
}

}  // namespace kickstand::motionplan::wire
