#pragma once

#include <QAbstractButton>

#include "ui/thunderbots/tile_content.h"

namespace kickstand::ui {

struct TileLayout;

/// One robot: its number, its voltages and how full they are, and what it is up to.
class RobotTile final : public QAbstractButton {
    Q_OBJECT
  public:
    explicit RobotTile(int robot, QWidget* parent = nullptr);

    int robot() const { return content_.robot; }
    const TileContent& content() const { return content_; }
    void setContent(TileContent content);

    static constexpr int kLeastHeight = 64;
    static constexpr int kMostHeight = 84;

  signals:
    /// Clicked, or chosen by key.
    void picked(int robot, Qt::KeyboardModifiers modifiers);
    /// The focus is to go to a neighbour.
    void stepped(int robot, int key, Qt::KeyboardModifiers modifiers);
    /// A tool tip is about to be shown: setToolTip() now.
    void tipWanted(int robot);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void paintFrame(QPainter& painter) const;
    void paintReadings(QPainter& painter, const TileLayout& places) const;
    void paintState(QPainter& painter, const TileLayout& places) const;

    TileContent content_;
};

}  // namespace kickstand::ui
