#pragma once

#include <vector>

#include "ui/shell/panel.h"

class QLabel;

namespace kickstand::ui {

class DeviceCard;
class DeviceChoice;

/// All boards at a glance, a card each, in rows as wide as there is room.
class CardsPanel final : public Panel {
    Q_OBJECT
  public:
    CardsPanel(Bench& bench, DeviceChoice& choice, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {280, 160}; }

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void refresh();
    void addCard(int device);
    void place();

    DeviceChoice& choice_;
    QLabel* empty_;
    std::vector<DeviceCard*> cards_;  ///< By the boards' numbers.
};

}  // namespace kickstand::ui
