#pragma once

#include "core/coach/commands.h"
#include "core/coach/snapshot.h"
#include "ui/shell/panel.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

class ChartView;
class ConversationView;

/// The TOWRP: this program is the boat, so that a team can test its own COACH.
class TowrpPanel final : public Panel {
    Q_OBJECT
  public:
    explicit TowrpPanel(Bench& bench, QWidget* parent = nullptr);

  private:
    void build();
    void refresh();
    void showBoat(const coach::Snapshot& snapshot);
    void submit(const coach::Command& command);

    QLabel* empty_;
    QWidget* body_;
    QSpinBox* team_;
    QPushButton* start_;
    QPushButton* end_;
    QLabel* notice_;  ///< Why the last command was not done.
    QLabel* velocity_;
    QLabel* received_;
    QLabel* morale_;
    QSpinBox* wanted_;
    QPushButton* set_;
    QPushButton* mutiny_;
    ChartView* chart_;
    ConversationView* conversation_;
};

}  // namespace kickstand::ui
