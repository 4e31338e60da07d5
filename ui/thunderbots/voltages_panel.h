#pragma once

#include <QTimer>
#include <optional>

#include "ui/shell/panel.h"
#include "ui/thunderbots/voltages_contents.h"

class QLabel;
class QMenu;
class QPushButton;

namespace kickstand::ui {

class RobotChoice;
class TimePlot;
class VoltagesTable;
class VoltagesTrigger;

/// Live curves of what the robots measure: those of the robots that are chosen, or of some that are pinned;
/// of all that are heard where none is chosen. Beside them a table of the same in numbers.
class VoltagesPanel final : public Panel {
    Q_OBJECT
  public:
    VoltagesPanel(Bench& bench, RobotChoice& choice, QWidget* parent = nullptr);

    QWidget* headerTools() override;
    TimePlot& plot() { return *plot_; }
    /// Writes what is seen; says in the panel whether it could.
    bool savePicture(const QString& file);
    bool saveValues(const QString& file);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void build();
    QPushButton* robotsButton(QWidget* parent);
    QPushButton* signalsButton(QWidget* parent);
    QPushButton* saveButton(QWidget* parent);
    QPushButton* toggle(const QString& text, const char* name, const QString& tip, QWidget* parent);

    thunderbots::RobotMask robots() const;
    void refresh();
    void refreshContents();
    void refreshNumbers();
    void refreshTools();
    void refreshEmpty();
    void pin(std::optional<thunderbots::RobotMask> robots);
    void setSignal(thunderbots::Signal signal, bool shown);
    void askFile(const QString& title, const QString& suffix, bool (VoltagesPanel::*save)(const QString&));
    bool saved(const QString& file, const QString& error);
    void say(const QString& text);
    QPixmap bodyPicture();

    RobotChoice& choice_;
    TimePlot* plot_;
    VoltagesTable* table_;
    VoltagesTrigger* trigger_;
    QWidget* body_;
    QLabel* empty_;
    QLabel* message_;
    QMenu* robotsMenu_ = nullptr;
    QPushButton* robotsButton_ = nullptr;
    QPushButton* triggerButton_ = nullptr;

    std::optional<thunderbots::RobotMask> pinned_;
    SignalMask signals_;
    thunderbots::RobotMask shownRobots_ = 0;
    SignalMask shownSignals_ = 0;
    QTimer numbers_;
    QTimer quiet_;
};

}  // namespace kickstand::ui
