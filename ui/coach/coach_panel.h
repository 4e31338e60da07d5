#pragma once

#include "core/coach/commands.h"
#include "core/coach/snapshot.h"
#include "ui/shell/panel.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QVBoxLayout;

namespace kickstand::ui {

class ChartView;
class ConversationView;
class HelmPad;
class MoraleView;

/// The COACH: startup, the boats that are heard, the helm, morale and mutiny.
class CoachPanel final : public Panel {
    Q_OBJECT
  public:
    explicit CoachPanel(Bench& bench, QWidget* parent = nullptr);
    void closed() override;

  private:
    QVBoxLayout* buildBoats();
    QVBoxLayout* buildHelm();
    QVBoxLayout* buildCrew();
    void buildSeries(const std::vector<std::string>& actions);
    void refresh();
    void showBoats(const coach::Snapshot& snapshot);
    void showHelm(const coach::Snapshot& snapshot);
    std::vector<float> moraleHistory(const coach::Snapshot& snapshot) const;
    void showCrew(const coach::Snapshot& snapshot);
    void showChart(const coach::Snapshot& snapshot);
    void fillBoats(const coach::Snapshot& snapshot);
    std::optional<coach::Team> chosenBoat() const;
    void pairChosen();
    void offerPair();
    void nameSeries();
    void submit(const coach::Command& command);
    QPushButton* button(const char* name, const QString& text, const coach::Command& command);

    QSpinBox* team_;
    QComboBox* color_;
    QPushButton* start_;
    QPushButton* end_;
    QTableWidget* boats_;
    QPushButton* pair_;
    QCheckBox* mayJettison_;
    QPushButton* jettison_;
    HelmPad* helm_;
    QLabel* told_;
    QPushButton* digital_;
    QSpinBox* percent_;
    QPushButton* analog_;
    MoraleView* morale_;
    QLabel* mutiny_;
    QWidget* actions_;
    QHBoxLayout* actionRow_;
    std::vector<QPushButton*> actionButtons_;
    std::vector<std::string> series_;
    QPushButton* suppress_;
    QLineEdit* names_;
    QLabel* empty_;
    QWidget* body_;
    ChartView* chart_;
    ConversationView* conversation_;
};

}  // namespace kickstand::ui
