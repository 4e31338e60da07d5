#pragma once

#include <QWidget>

#include "ui/thunderbots/leds_words.h"

namespace kickstand::ui {

/// The four LEDs of a robot, drawn as they lie, each with what it means in the mode that is shown.
class LedLights final : public QWidget {
    Q_OBJECT
  public:
    explicit LedLights(QWidget* parent = nullptr);

    void setMode(const thunderbots::wire::TestMode& mode);
    const std::array<LedMeaning, 4>& meanings() const { return meanings_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    double centreOf(std::size_t led) const;

    std::array<LedMeaning, 4> meanings_;
};

}  // namespace kickstand::ui
