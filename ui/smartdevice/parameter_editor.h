#pragma once

#include <QWidget>
#include <optional>

#include "core/smartdevice/catalogue.h"

namespace kickstand::ui {

/// What a person sets a parameter with. It shows what it is told; `asked` is what a person wants.
class ParameterEditor : public QWidget {
    Q_OBJECT
  public:
    using QWidget::QWidget;

    /// Ignored while a person is at it.
    virtual void showValue(const std::optional<smartdevice::wire::Value>& value) = 0;

  signals:
    void asked(const kickstand::smartdevice::wire::Value& value);
    /// What was typed is no value of the parameter.
    void refused(const kickstand::Error& error);
};

/// The editor that fits: a switch for a bool, a slider with a number for what has bounds, a number
/// otherwise; bytes in hexadecimal for what no catalogue knows. `name` is what the controls are called.
ParameterEditor* makeParameterEditor(const smartdevice::ParameterSpec& spec, const QString& name,
                                     QWidget* parent);

}  // namespace kickstand::ui
