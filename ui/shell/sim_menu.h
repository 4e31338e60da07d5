#pragma once

#include <QPushButton>

#include "core/link/sim_action.h"

class QMenu;

namespace kickstand::ui {

class Bench;

/// What a person can do to simulated robots from outside the wire: put a ball into a beam, drain a battery,
/// pull the plug. It offers what the simulator says it can do.
class SimMenu final : public QPushButton {
    Q_OBJECT
  public:
    explicit SimMenu(Bench& bench, QWidget* parent = nullptr);

  private:
    void fill();
    void addAction(const SimAction& action);
    void ask(const SimAction& action);
    void perform(const SimAction& action, double value);

    Bench& bench_;
    QMenu* menu_;
};

}  // namespace kickstand::ui
