#pragma once

#include "core/coach/commands.h"
#include "core/coach/snapshot.h"
#include "ui/gamepad/pad_follower.h"
#include "ui/shell/engine_client.h"
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
class HelmGamepad;
class HelmPad;
class MoraleView;

/// The COACH: startup, the boats that are heard, the helm, morale and mutiny.
class CoachPanel final : public Panel {
    Q_OBJECT
  public:
    CoachPanel(Bench& bench, MakePadSource makePads, QWidget* parent = nullptr);
    void closed() override;

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    QVBoxLayout* buildBoats();
    QVBoxLayout* buildHelm(MakePadSource makePads);
    QVBoxLayout* buildCrew();
    void buildSeries(const std::vector<std::string>& actions);
    void refresh();
    void showBoats(const coach::Snapshot& snapshot);
    void showHelm(const coach::Snapshot& snapshot);
    std::vector<float> moraleHistory(const coach::Snapshot& snapshot) const;
    void showCrew(const coach::Snapshot& snapshot);
    static QString stateOf(const coach::HeardBoat& boat, const coach::Snapshot& snapshot);
    void fillBoats(const coach::Snapshot& snapshot);
    std::optional<coach::Team> chosenBoat() const;
    void pairChosen();
    void offerPair();
    void nameSeries();
    void recallSeries();
    void setSeries(const QString& names, const EngineClient::Answered& answered);
    void showRefusal(const Result<void>& result);
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
    HelmGamepad* gamepad_;
    QPushButton* padOn_;
    QLabel* padState_;
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
    QLabel* notice_;  ///< Why the last command was not done.
    QLabel* empty_;
    QWidget* body_;
    ChartView* chart_;
    ConversationView* conversation_;
};

}  // namespace kickstand::ui
