#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <optional>

#include "ui/thunderbots/drive_keys.h"

class QKeyEvent;
class QPushButton;
class QSettings;

namespace kickstand::ui {

class SignedSpinBox;

/// Hold-to-drive by keyboard: a switch, the keys, how fast they drive. While it is on, the keys are heard
/// wherever the focus is in this window but where letters are typed.
class DriveKeysBox final : public QWidget {
    Q_OBJECT
  public:
    explicit DriveKeysBox(QSettings& settings, QWidget* parent = nullptr);

    void setUsable(bool usable);
    /// Nothing counts as held any more; keys must be pressed anew.
    void letGo();
    const HeldKeys& held() const { return held_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

  signals:
    /// The keys that are held are others: −1 to 1 of each, times the part of the limit that is set.
    void asked(const kickstand::ui::BodyMotion& part);
    /// Something stopped by itself, as a sentence.
    void noticed(const QString& words);

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* makeCaps();
    bool hears(const QKeyEvent& event) const;
    bool press(const QKeyEvent& event);
    bool release(const QKeyEvent& event);
    bool learn(const QKeyEvent& event);
    void setLearning(std::optional<DriveKey> key);
    void focusMoved();
    void tell();
    void showCaps();

    QSettings& settings_;
    DriveKeyMap map_;
    HeldKeys held_;
    std::optional<DriveKey> learning_;
    bool usable_ = true;
    QPushButton* on_;
    std::array<QPushButton*, kDriveKeys.size()> caps_{};
    SignedSpinBox* speed_;
    QTimer watch_;
};

}  // namespace kickstand::ui
