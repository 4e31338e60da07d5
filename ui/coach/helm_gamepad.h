#pragma once

#include <QObject>

#include "ui/gamepad/pad_follower.h"
#include "ui/gamepad/pad_reader.h"

namespace kickstand::ui {

class Bench;
class HelmPad;

/// Steers a boat with a gamepad, through the helm: forward and turning as the Gamepad panel of the
/// Thunderbots has them set. What is held counts once it has been let go; a gamepad that is lost lets the
/// helm go. GUI thread.
class HelmGamepad final : public QObject {
    Q_OBJECT
  public:
    HelmGamepad(Bench& bench, HelmPad& helm, MakePadSource makeSource, QObject* parent = nullptr);

    /// Whether it steers. From the first time on its STOP button counts in any case.
    void setOn(bool on);
    bool isOn() const { return on_; }
    /// From here on the sticks must be let go before they count.
    void awaitNeutral();
    /// How it stands, as a sentence.
    QString stateText() const;

  signals:
    void changed();

  private:
    void look(const PadState& state);
    void drop();

    Bench& bench_;
    HelmPad& helm_;
    PadFollower pads_;
    PadReader reader_;
    bool on_ = false;
    bool awaitsNeutral_ = true;
    bool steers_ = false;  ///< The sticks have been off the middle since they last were there.
    bool gone_ = false;
};

}  // namespace kickstand::ui
