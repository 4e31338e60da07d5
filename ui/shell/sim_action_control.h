#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

#include "core/link/sim_action.h"

class QComboBox;
class QDoubleSpinBox;

namespace kickstand {
struct SessionSnapshot;
}

namespace kickstand::ui {

class Segmented;

/// Whether a unit has what an action changes: not where others show its quantity and this one shows none, as
/// a motor has no battery.
bool hasAction(const SessionSnapshot& session, const SimAction& action, int unit);

/// One action of a simulator as a control that suits it: a button, a choice of few, a list with a button, or
/// a number. It shows the present value of what it changes, and only asks.
class SimActionControl final : public QWidget {
    Q_OBJECT
  public:
    /// `choices`: the values that have names; none for a number. `name` is read to those who do not see.
    SimActionControl(const SimAction& action, const std::vector<std::pair<QString, double>>& choices,
                     const QString& name, QWidget* parent = nullptr);

    /// What it is now; nothing where the action has no quantity.
    void showValue(std::optional<double> value);

  signals:
    void asked(double value);

  private:
    void addButton(const QString& text, const QString& name, double value);
    void addSegments(const QString& name);
    void addList(const QString& name);
    void addNumber(const SimAction& action, const QString& name);

    std::vector<std::pair<QString, double>> choices_;
    double scale_ = 1;
    Segmented* segments_ = nullptr;
    QDoubleSpinBox* number_ = nullptr;
};

}  // namespace kickstand::ui
