#pragma once

#include "ui/shell/event_model.h"
#include "ui/shell/panel.h"

class QLabel;
class QTableView;

namespace kickstand::ui {

/// Everything that happened, in plain words: the engine's events, and commands that were refused.
class EventsPanel final : public Panel {
    Q_OBJECT
  public:
    explicit EventsPanel(Bench& bench, QWidget* parent = nullptr);

    QWidget* headerTools() override;

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void buildView();
    void take(const std::vector<EngineEvent>& events, quint64 lost);
    void takeRefusal(const Error& error);
    void copySelection();
    void refreshEmpty();

    EventModel model_;
    EventFilter filter_;
    QTableView* view_;
    QLabel* empty_;
};

}  // namespace kickstand::ui
