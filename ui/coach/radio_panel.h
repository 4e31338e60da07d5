#pragma once

#include <array>

#include "core/coach/commands.h"
#include "core/coach/snapshot.h"
#include "ui/shell/panel.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

/// The radio module: found at whatever speed it is, one draft of its settings, applied and read back.
class RadioPanel final : public Panel {
    Q_OBJECT
  public:
    explicit RadioPanel(Bench& bench, QWidget* parent = nullptr);

  private:
    void build();
    void refresh();
    void usePreset();
    void showDraft(const coach::RadioSettings& settings);
    coach::RadioSettings draft() const;
    void showChanges();
    void showHeld(const coach::RadioSettings& draft);
    void submit(const coach::Command& command);

    QLabel* state_;
    QPushButton* find_;
    QComboBox* preset_;
    QSpinBox* number_;
    QPushButton* use_;
    QSpinBox* address_;
    QSpinBox* channel_;
    QSpinBox* pan_;
    QComboBox* mode_;
    QComboBox* baud_;
    QLineEdit* name_;
    std::array<QLabel*, 6> held_{};  ///< What the module holds, beside each field that is to change it.
    QLabel* changes_;
    QLabel* notice_;  ///< Why the last command was not done.
    QPushButton* apply_;
    QPushButton* undo_;
    std::optional<coach::RadioSettings> read_;  ///< What the draft was last filled from.
};

}  // namespace kickstand::ui
