#pragma once

#include <QScrollArea>

namespace kickstand::ui {

/// As high as its content, with the scroll bar under it: what is too wide is scrolled sideways by itself, and
/// what stands around it stays where it is.
class WideScroll final : public QScrollArea {
    Q_OBJECT
  public:
    /// Takes over the content, which has its layout already.
    WideScroll(QWidget* content, QWidget* parent);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace kickstand::ui
