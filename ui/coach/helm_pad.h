#pragma once

#include <QWidget>
#include <optional>
#include <set>

#include "core/coach/wire/velocity.h"

namespace kickstand::ui {

/// The helm: pulled with the pointer or by the arrow keys, forward and turn at once, snapped to the levels
/// that there are. Let go, it is back at zero.
class HelmPad final : public QWidget {
    Q_OBJECT
  public:
    explicit HelmPad(QWidget* parent = nullptr);

    /// What the boat was told last, and whether it answered.
    void setTold(const std::optional<coach::wire::Velocity>& velocity, bool answered);
    /// Ends a pull as if everything had been let go.
    void letGo();
    /// Something beside pointer and keys asks for this, as a gamepad does. Not taken, and false, while one of
    /// them pulls, or where the helm cannot be seen or used.
    bool hold(const coach::wire::Velocity& velocity);
    const coach::wire::Velocity& asked() const { return asked_; }

    QSize sizeHint() const override { return {176, 176}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

  signals:
    /// Somebody holds it so, or has let it go. A pull begins with zero.
    void steered(int forward, int turn);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QRectF field() const;
    void drawLevels(QPainter& painter, const QRectF& place) const;
    QPointF placeOf(const coach::wire::Velocity& velocity) const;
    void pull(const QPointF& at);
    void followKeys(bool fine);
    bool isPulled() const { return pulled_ || !keys_.empty(); }
    void ask(const coach::wire::Velocity& velocity);

    coach::wire::Velocity asked_;
    std::optional<coach::wire::Velocity> told_;
    bool answered_ = false;
    bool pulled_ = false;
    std::set<int> keys_;
};

}  // namespace kickstand::ui
