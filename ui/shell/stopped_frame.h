#pragma once

#include <QWidget>

namespace kickstand::ui {

/// A red frame round the whole window while everything is stopped. It lets every click through.
class StoppedFrame final : public QWidget {
    Q_OBJECT
  public:
    explicit StoppedFrame(QWidget* parent);

  protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace kickstand::ui
