#pragma once

#include <QWidget>

#include "ui/thunderbots/flash_wizard_state.h"

namespace kickstand::ui {

/// Where in the wizard a person is: "1 Robots — 2 Files — …", with what lies behind ticked off.
class FlashStepStrip final : public QWidget {
    Q_OBJECT
  public:
    explicit FlashStepStrip(QWidget* parent = nullptr);

    void setStep(FlashStep step);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    FlashStep step_ = FlashStep::Robots;
};

}  // namespace kickstand::ui
