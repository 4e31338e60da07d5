#pragma once

#include <QWidget>

#include "core/motionplan/plan.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

/// One movement as a person enters it: which way, how far, and what can be done where that has no code.
class PlanStepRow final : public QWidget {
    Q_OBJECT
  public:
    explicit PlanStepRow(QWidget* parent = nullptr);

    motionplan::Movement movement() const;
    void setMovement(const motionplan::Movement& movement);
    /// Whether there is a step that "Change" would change.
    void setCanChange(bool can);

  signals:
    /// These are to be added, or put in the place of the chosen step.
    void added(const std::vector<kickstand::motionplan::Movement>& movements);
    void changed(const std::vector<kickstand::motionplan::Movement>& movements);

  private:
    void refresh();
    /// The movement, or the exact sum that stands for it; none where there is none.
    std::vector<motionplan::Movement> wanted() const;

    QComboBox* way_;
    QSpinBox* amount_;
    QPushButton* add_;
    QPushButton* change_;
    QLabel* offer_;
    bool canChange_ = false;
};

}  // namespace kickstand::ui
