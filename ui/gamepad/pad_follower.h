#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/gamepad/pad_map.h"
#include "ui/gamepad/pad_source.h"
#include "ui/gamepad/stick_curve.h"

class QSettings;

namespace kickstand::ui {

/// Makes a source of gamepads when somebody first wants one.
using MakePadSource = std::function<std::unique_ptr<PadSource>()>;

/// Looks at gamepads by a timer of its own, and stays with one: the one that was used last, by its model.
/// What its inputs do and how its sticks feel is remembered. GUI thread.
class PadFollower final : public QObject {
    Q_OBJECT
  public:
    PadFollower(QSettings& settings, MakePadSource makeSource, QObject* parent = nullptr);

    /// Begins to look for gamepads. Done as well where it has begun.
    void open();
    const std::vector<PadInfo>& pads() const { return pads_; }
    /// The one that is chosen, whether it is plugged in or not; its model is empty while none has been.
    const PadInfo& chosen() const { return chosen_; }
    bool isThere() const { return there_; }
    void choose(const PadInfo& pad);
    /// Whether nothing on it has moved for five seconds. One that has gone to sleep, or out of reach, may go
    /// on telling what it told last, and no hand that holds a stick is so still.
    bool isAsleep() const;

    const PadMap& map() const { return map_; }
    void setMap(const PadMap& map);
    const StickCurve& curve() const { return curve_; }
    void setCurve(const StickCurve& curve);

  signals:
    /// Another gamepad is the chosen one, or it is back.
    void chose();
    /// The chosen one is gone.
    void lost();
    /// What is plugged in has changed.
    void changed();
    /// How the chosen one stands, each time that it has been looked at.
    void looked(const kickstand::ui::PadState& state);

  private:
    void poll();
    void followPads();
    void lose();

    QSettings& settings_;
    MakePadSource makeSource_;
    std::unique_ptr<PadSource> source_;
    std::vector<PadInfo> pads_;
    PadInfo chosen_;
    bool there_ = false;
    PadState state_;
    QElapsedTimer moved_;  ///< Since something last moved on it.
    PadMap map_;
    StickCurve curve_;
    QTimer timer_;
};

}  // namespace kickstand::ui
