#pragma once

#include <QObject>
#include <vector>

#include "core/thunderbots/types.h"

namespace kickstand::ui {

/// Which robots a person has chosen: every panel of this system works on these. GUI thread.
class RobotChoice final : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    thunderbots::RobotMask chosen() const { return chosen_; }
    bool isChosen(int robot) const { return thunderbots::contains(chosen_, robot); }

    void choose(thunderbots::RobotMask robots);
    /// As lists have it: alone, Ctrl adds or takes away, Shift takes all from the last one to this one in
    /// `order`.
    void pick(int robot, Qt::KeyboardModifiers modifiers, const std::vector<int>& order);

  signals:
    void changed();

  private:
    thunderbots::RobotMask chosen_ = 0;
    int anchor_ = -1;
};

}  // namespace kickstand::ui
