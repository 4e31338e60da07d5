#pragma once

#include <QAbstractButton>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

/// A board at a glance. A click asks for more about it.
class DeviceCard final : public QAbstractButton {
    Q_OBJECT
  public:
    explicit DeviceCard(QWidget* parent = nullptr);

    /// What its board is called and how it stands, over what it is about.
    void showCard(const QString& title, const QString& kind, const Standing& standing,
                  const CardContent& content, bool grey);
    const CardContent& content() const { return content_; }
    /// In cards.
    int span() const { return content_.width; }

    static constexpr int kWidth = 252;
    static constexpr int kHeight = 148;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString kind_;
    Standing standing_;
    CardContent content_;
    bool grey_ = false;
};

}  // namespace kickstand::ui
