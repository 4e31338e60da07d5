#include "ui/thunderbots/drive_keys.h"

#include <algorithm>

namespace kickstand::ui {

namespace {

/// Zero, in the Drive panel.
constexpr char kTaken = 'Z';

bool isFree(char letter) {
    return letter >= 'A' && letter <= 'Z' && letter != kTaken;
}

}  // namespace

bool DriveKeyMap::setLetters(std::string_view letters) {
    if (letters.size() != letters_.size()) return false;
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (!isFree(letters[i]) || letters.find(letters[i]) != i) return false;
    }
    std::copy(letters.begin(), letters.end(), letters_.begin());
    return true;
}

bool DriveKeyMap::setLetter(DriveKey key, char letter) {
    if (!isFree(letter)) return false;
    char& own = letters_[static_cast<std::size_t>(key)];
    std::replace(letters_.begin(), letters_.end(), letter, own);
    own = letter;
    return true;
}

std::optional<DriveKey> DriveKeyMap::find(int code) const {
    // Qt numbers its letter keys as ASCII does.
    for (const DriveKey key : kDriveKeys) {
        if (letter(key) == code) return key;
    }
    return std::nullopt;
}

void HeldKeys::press(DriveKey key, bool repeated, TimePoint now) {
    bool& held = held_[static_cast<std::size_t>(key)];
    if (repeated && !held) return;
    held = true;
    deadline_ = now + (repeated ? kNextRepeat : kFirstRepeat);
}

void HeldKeys::release(DriveKey key, TimePoint now) {
    held_[static_cast<std::size_t>(key)] = false;
    // Those that stay down are not repeated any more: they count for as long as a new one would.
    deadline_ = now + kFirstRepeat;
}

bool HeldKeys::expire(TimePoint now) {
    if (!any() || now < deadline_) return false;
    letGo();
    return true;
}

bool HeldKeys::any() const {
    return std::find(held_.begin(), held_.end(), true) != held_.end();
}

BodyMotion HeldKeys::direction() const {
    const auto pull = [this](DriveKey plus, DriveKey minus) {
        return (isHeld(plus) ? 1.0 : 0.0) - (isHeld(minus) ? 1.0 : 0.0);
    };
    return {pull(DriveKey::Forward, DriveKey::Back), pull(DriveKey::Left, DriveKey::Right),
            pull(DriveKey::TurnLeft, DriveKey::TurnRight)};
}

}  // namespace kickstand::ui
