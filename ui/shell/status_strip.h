#pragma once

#include <QWidget>

class QLabel;

namespace kickstand::ui {

class Bench;

/// The bar at the bottom: the link and a few facts about it, quietly.
class StatusStrip final : public QWidget {
    Q_OBJECT
  public:
    explicit StatusStrip(Bench& bench, QWidget* parent = nullptr);

  signals:
    void doctorAsked();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void refresh();

    Bench& bench_;
    QLabel* link_;
    QLabel* facts_;
};

}  // namespace kickstand::ui
