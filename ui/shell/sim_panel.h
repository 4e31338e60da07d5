#pragma once

#include <map>
#include <vector>

#include "core/base/result.h"
#include "core/link/sim_action.h"
#include "ui/shell/panel.h"

class QLabel;

namespace kickstand::ui {

class SimActionControl;

/// What a person can do to simulated robots from outside the wire: a row for each one that is chosen, and
/// what concerns all of them. It is made of what the simulator says it can do, whatever the system.
class SimPanel final : public Panel {
    Q_OBJECT
  public:
    explicit SimPanel(Bench& bench, QWidget* parent = nullptr);

  private:
    /// What the controls were made for: they are made anew when it changes.
    struct Shape {
        quint32 session = 0;
        std::vector<SimAction> actions;
        std::vector<int> units;
        std::vector<std::vector<bool>> has;  ///< By unit and action.
        bool operator==(const Shape&) const = default;
    };

    void refresh();
    Shape shapeNow() const;
    void build();
    void addUnits();
    void addOneUnit();
    void addTable();
    void addShared();
    QLabel* unitName(int unit) const;
    /// A control under its name.
    QWidget* addField(const SimAction& action, int unit);
    SimActionControl* add(const SimAction& action, int unit);
    void perform(const SimAction& action, int unit, double value);
    void showAnswer(const Result<void>& result);

    QWidget* units_;
    QWidget* shared_;
    QLabel* hint_;
    QLabel* notice_;
    Shape shape_;
    std::map<std::pair<std::string, int>, SimActionControl*> controls_;
};

}  // namespace kickstand::ui
