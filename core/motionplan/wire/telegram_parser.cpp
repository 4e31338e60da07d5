#include "core/motionplan/wire/telegram_parser.h"

namespace kickstand::motionplan::wire {

void TelegramParser::feed(ByteView bytes, const std::function<void(const Telegram&)>& take) {
    for (const std::uint8_t byte : bytes) {
        held_.push_back(byte);
        // Where what is held cannot go on like this, a telegram may still begin later within it.
        while (!held_.empty() && telegramSize(held_) == 0) {
            held_.erase(held_.begin());
            ++counters_.skipped;
        }
        if (held_.empty() || held_.size() < telegramSize(held_)) continue;
        const auto telegram = decodeTelegram(held_);
        held_.clear();
        if (!telegram) {
            ++counters_.malformed;
            continue;
        }
        ++counters_.telegrams;
        take(*telegram);
    }
}

void TelegramParser::abandon() {
    counters_.skipped += held_.size();
    held_.clear();
}

}  // namespace kickstand::motionplan::wire
