#pragma once

#include "core/motionplan/snapshot.h"
#include "ui/shell/panel.h"

class QLabel;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

class PlanDocument;
class PlanPath;
class PlanStepRow;

/// The plan editor: steps with their bytes, and the way that they lead, drawn to scale.
class PlanPanel final : public Panel {
    Q_OBJECT
  public:
    PlanPanel(Bench& bench, PlanDocument& document, QWidget* parent = nullptr);

  private:
    void build();
    QWidget* makeButtons();
    void connectDocument();
    void connectButtons();
    void connectKeys();
    void refreshSteps();
    void refreshState();
    /// Marks the row of the step that executes, from 1; 0 for none.
    void markExecuting(int step);
    /// What executes and is not the plan here, and why it is not drawn.
    QString elsewhereText(const motionplan::Execution& execution) const;
    void rowsMoved();
    int chosen() const;
    void choose(int row);
    void split();
    void open();
    void save();
    /// How much of the step is thought to be done, by the time since it was first heard of.
    double doneOf(const motionplan::Execution& execution, TimePoint now) const;

    PlanDocument& document_;
    QListWidget* steps_;
    PlanStepRow* row_;
    PlanPath* path_;
    QLabel* header_;
    QLabel* length_;
    QLabel* notice_;
    QLabel* elsewhere_;
    QSpinBox* track_;
    QPushButton* duplicate_;
    QPushButton* remove_;
    QPushButton* up_;
    QPushButton* down_;
    QPushButton* split_;
    QPushButton* undo_;
    QPushButton* redo_;
    QPushButton* open_;
    QPushButton* save_;
};

}  // namespace kickstand::ui
