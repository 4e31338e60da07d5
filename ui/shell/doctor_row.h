#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace kickstand {
struct Finding;
}

namespace kickstand::ui {

class StateLabel;

/// One thing that was looked at: how it stands as a shape and a word, what there is, what to do about it, and
/// the command that does it.
class DoctorRow final : public QWidget {
    Q_OBJECT
  public:
    explicit DoctorRow(QWidget* parent = nullptr);

    void showFinding(const Finding& finding);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    StateLabel* state_;
    QLabel* check_;
    QLabel* what_;
    QLabel* remedy_;
    QPushButton* copy_;
    QString command_;
};

}  // namespace kickstand::ui
