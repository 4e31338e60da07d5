#pragma once

#include <QWidget>

#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::ui {

class SignedSpinBox;

/// Two widths and the offset as numbers. What is typed goes to the nearest step of 32 µs, and that is said.
class KickFields final : public QWidget {
    Q_OBJECT
  public:
    explicit KickFields(QWidget* parent = nullptr);

    /// Shows pulses without asking for anything.
    void showPulses(const thunderbots::wire::KickPulses& pulses);

  signals:
    void asked(const kickstand::thunderbots::wire::KickPulses& pulses);
    /// A typed number is not on the grid; in words. Empty: it is.
    void snapped(const QString& words);

  private:
    SignedSpinBox* addField(const char* name, const QString& label, int lowest);
    void changed(SignedSpinBox* field, int value);

    SignedSpinBox* width1_;
    SignedSpinBox* width2_;
    SignedSpinBox* offset_;
    bool telling_ = false;
};

}  // namespace kickstand::ui
