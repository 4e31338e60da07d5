#pragma once

#include <QWidget>
#include <optional>
#include <vector>

namespace kickstand::ui {

/// The crew's morale: the number as large as it goes, a ring around it that runs out during a mutiny, and how
/// it was in the last minute.
class MoraleView final : public QWidget {
    Q_OBJECT
  public:
    explicit MoraleView(QWidget* parent = nullptr);

    /// `left`: the part of a mutiny's time that is left, 0-1; nothing while there is none. `history`: oldest
    /// first, evenly spaced, not finite where nothing is known.
    void show(std::optional<int> morale, std::optional<double> left, std::vector<float> history);
    QString text() const;
    std::optional<double> ring() const { return left_; }
    const std::vector<float>& history() const { return history_; }

    QSize sizeHint() const override { return {240, 88}; }
    QSize minimumSizeHint() const override { return {200, 88}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void drawNumber(QPainter& painter, const QRectF& place);
    void drawHistory(QPainter& painter, const QRectF& place);

    std::optional<int> morale_;
    std::optional<double> left_;
    std::vector<float> history_;
};

}  // namespace kickstand::ui
