#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/base/time.h"
#include "ui/thunderbots/body_motion.h"

namespace kickstand::ui {

/// What a key can do while it is held.
enum class DriveKey { Forward, Back, Left, Right, TurnLeft, TurnRight };
inline constexpr std::array kDriveKeys{DriveKey::Forward, DriveKey::Back,     DriveKey::Left,
                                       DriveKey::Right,   DriveKey::TurnLeft, DriveKey::TurnRight};

/// Which letter does what.
class DriveKeyMap {
  public:
    /// W A S D to go, Q and E to turn.
    static constexpr std::string_view kDefault = "WSADQE";

    /// Six different letters in the order of kDriveKeys, none of them taken for something else; anything else
    /// leaves the map as it is. Tells whether it was taken.
    bool setLetters(std::string_view letters);
    std::string_view letters() const { return {letters_.data(), letters_.size()}; }
    char letter(DriveKey key) const { return letters_[static_cast<std::size_t>(key)]; }
    /// Gives a key another letter; where that has been another key's, the two change places. False for what
    /// is no letter or is taken.
    bool setLetter(DriveKey key, char letter);
    /// What a key code of Qt does.
    std::optional<DriveKey> find(int code) const;

  private:
    std::array<char, kDriveKeys.size()> letters_{'W', 'S', 'A', 'D', 'Q', 'E'};
};

/// Which keys are held. A keyboard repeats the key that was pressed last for as long as it is down: when that
/// ends without a release, the release has been lost, and nothing counts as held any more. Pure.
class HeldKeys {
  public:
    /// A keyboard begins to repeat within this.
    static constexpr Duration kFirstRepeat = std::chrono::milliseconds(1200);
    /// And goes on at least as often as this.
    static constexpr Duration kNextRepeat = std::chrono::milliseconds(600);

    /// `repeated`: by the keyboard. Such a one keeps what is held alive; it presses nothing.
    void press(DriveKey key, bool repeated, TimePoint now);
    void release(DriveKey key, TimePoint now);
    /// Nothing is held any more; what is still down must be pressed anew.
    void letGo() { held_.fill(false); }
    /// True when the repeats have ended: everything has been let go.
    bool expire(TimePoint now);

    bool isHeld(DriveKey key) const { return held_[static_cast<std::size_t>(key)]; }
    bool any() const;
    /// −1, 0 or 1 of each of the three; keys that pull against each other give 0.
    BodyMotion direction() const;

  private:
    std::array<bool, kDriveKeys.size()> held_{};
    TimePoint deadline_{};
};

}  // namespace kickstand::ui
