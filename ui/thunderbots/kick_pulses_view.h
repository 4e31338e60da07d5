#pragma once

#include <QWidget>
#include <array>

#include "ui/thunderbots/kick_diagram.h"

namespace kickstand::ui {

class PulseHandle;

/// Both solenoids' pulses to scale, with edges that can be pulled by mouse and, having the focus, by
/// keyboard: an arrow is 32 µs, Page 320. It shows what it is told; `asked` is what a person wants.
class KickPulsesView final : public QWidget {
    Q_OBJECT
  public:
    explicit KickPulsesView(QWidget* parent = nullptr);

    void showPulses(const thunderbots::wire::KickPulses& pulses);
    /// What gives each pulse alone: said beside it.
    void setLabels(const QString& first, const QString& second);
    const thunderbots::wire::KickPulses& pulses() const { return pulses_; }
    PulseAxis axis() const;
    PulseHandle* handle(PulseEdge edge) const { return handles_[static_cast<std::size_t>(edge)]; }
    /// Pulls an edge to a time, as a hand does.
    void pull(PulseEdge edge, int time_us);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void asked(const kickstand::thunderbots::wire::KickPulses& pulses);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void placeHandles();
    void paintScale(QPainter& painter) const;
    void paintPulse(QPainter& painter, int solenoid) const;
    double baseOf(int solenoid) const;

    thunderbots::wire::KickPulses pulses_;
    std::array<QString, 2> labels_;
    std::array<PulseHandle*, kPulseEdges.size()> handles_{};
};

/// One edge as something to take hold of.
class PulseHandle final : public QWidget {
    Q_OBJECT
  public:
    PulseHandle(PulseEdge edge, KickPulsesView* view);
    static constexpr int kSize = 20;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    KickPulsesView& view_;
    const PulseEdge edge_;
    double grip_px_ = 0;  ///< From the edge to where it was taken hold of.
    bool held_ = false;
};

}  // namespace kickstand::ui
