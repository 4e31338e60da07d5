#pragma once

#include <array>

#include "ui/gamepad/pad_map.h"
#include "ui/shell/panel.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

class DriveControl;
class DrivePad;
class PadPicture;
class Segmented;
class StateLabel;

/// The gamepad: which one, what its sticks and buttons do, how they feel, and whether it drives.
class DrivePadPanel final : public Panel {
    Q_OBJECT
  public:
    DrivePadPanel(Bench& bench, DriveControl& control, DrivePad* pad, QWidget* parent = nullptr);

    /// A gamepad does not drive from a panel that is gone.
    void closed() override;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* makeTop();
    QWidget* makeMap();
    QWidget* makeFeel();
    QSpinBox* makeNumber(const char* name, const QString& meaning, int lowest, int highest, int value);
    void refresh();
    void showPads();
    void showMap();
    void showPicture();
    QString stateText() const;
    /// Whether what is done on the gamepad does not count though it is to drive.
    bool isHeldUp() const;
    QWidget* makeState();
    void setFeel();

    DriveControl& control_;
    DrivePad* pad_;
    QComboBox* pads_ = nullptr;
    QPushButton* on_ = nullptr;
    Segmented* mode_ = nullptr;
    std::array<QLabel*, kPadActions.size()> labels_{};
    std::array<QPushButton*, kPadActions.size()> inputs_{};
    QPushButton* standard_ = nullptr;
    PadPicture* picture_ = nullptr;
    QSpinBox* dead_ = nullptr;
    QSpinBox* bend_ = nullptr;
    QSpinBox* speed_ = nullptr;
    StateLabel* sign_ = nullptr;  ///< Only its shape.
    QLabel* state_ = nullptr;
};

}  // namespace kickstand::ui
