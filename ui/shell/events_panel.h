#pragma once

#include "ui/shell/event_model.h"
#include "ui/shell/panel.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
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
    void addActions();
    void addFilters(QWidget* tools, QHBoxLayout* row);
    void addButtons(QWidget* tools, QHBoxLayout* row);
    void take(const std::vector<EngineEvent>& events, quint64 lost);
    void takeRefusal(const Error& error);
    QString placeOf(const EngineEvent& event) const;
    QString placeOfCurrent() const;
    void explainCurrent();
    void copySelection();
    void save();
    /// Somebody whom events concern, to be chosen from now on.
    void know(const QString& about);
    void keepPlace(int first, int last);
    void noteScroll(int value);
    void refreshEmpty();

    EventModel model_;
    EventFilter filter_;
    QTableView* view_;
    QLabel* empty_;
    QPushButton* follow_ = nullptr;
    QComboBox* units_ = nullptr;
    QStringList known_;     ///< In its order.
    bool placing_ = false;  ///< The view is being moved by the panel, not by a person.
};

}  // namespace kickstand::ui
