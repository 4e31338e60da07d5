#pragma once

#include <QWidget>
#include <optional>

#include "core/thunderbots/parameters.h"

class QComboBox;
class QSpinBox;

namespace kickstand::ui {

/// The control that edits one field of a robot's parameters: a list for what has names, numbers for the rest,
/// and for a duty its percentage beside it. It shows what it is told; a hand's edit only asks.
class ParametersField final : public QWidget {
    Q_OBJECT
  public:
    ParametersField(thunderbots::ParameterField field, QWidget* parent = nullptr);

    /// Shows a value, or nothing where there is none.
    void showValue(std::optional<std::uint8_t> value);

  signals:
    /// `goesOn`: part of the same edit as the one before, as while a number is typed or stepped.
    void asked(std::uint8_t value, bool goesOn);

  protected:
    /// Undo and redo mean the draft's steps, and not those of a line of text.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeList();
    void makeNumber();
    QSpinBox* addSpin(const char* suffix, int highest, const QString& unit);

    const thunderbots::ParameterField field_;
    QComboBox* list_ = nullptr;
    QSpinBox* number_ = nullptr;
    QSpinBox* percent_ = nullptr;
};

}  // namespace kickstand::ui
