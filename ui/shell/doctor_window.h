#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "core/engine/diagnosis.h"

class QVBoxLayout;

namespace kickstand::ui {

class Bench;
class DoctorRow;
class StateLabel;

/// "Why does it not work?": everything between this program and a robot that answers, looked at all the time
/// while the window is open; each line with its remedy.
class DoctorWindow final : public QWidget {
    Q_OBJECT
  public:
    explicit DoctorWindow(Bench& bench, QWidget* parent = nullptr);

    /// Everything in plain text, a line a check.
    QString report() const;

  signals:
    void helpAsked();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* makeList();
    QWidget* makeButtons();
    void refresh();
    void lookAgain();

    Bench& bench_;
    StateLabel* verdict_;
    QVBoxLayout* list_;
    std::vector<DoctorRow*> rows_;
    std::vector<Finding> findings_;
    QTimer look_;
};

}  // namespace kickstand::ui
