#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/smartdevice/snapshot.h"
#include "ui/shell/panel.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace kickstand::ui {

class Banner;
class DeviceChoice;
class ParameterRow;
class StateLabel;

/// The chosen board: what it is called, how it stands, what it sends by itself, and all its parameters.
class DevicePanel final : public Panel {
    Q_OBJECT
  public:
    DevicePanel(Bench& bench, DeviceChoice& choice, QWidget* parent = nullptr);

    /// What is driven from here must not go on unseen.
    void closed() override;

  private:
    void build();
    QWidget* makeHead();
    QWidget* makeUpdates();
    void connectHead();
    const smartdevice::Snapshot* snapshot() const;
    const smartdevice::DeviceState* device() const;
    void refresh();
    void refreshHead(const smartdevice::DeviceState& device);
    void rebuild(const smartdevice::DeviceState& device);
    void nameEdited();
    void subscribe(smartdevice::wire::ParameterMask mask, int delay_ms);
    void write(int parameter, const smartdevice::wire::Value& value);
    void submitWrite(int parameter, const smartdevice::wire::Value& value);
    void written(int device, int parameter, const Result<void>& result);
    void showFailure(int parameter, const Error& error);

    DeviceChoice& choice_;
    QLabel* empty_;
    QWidget* body_;
    QLineEdit* name_;
    QLabel* kind_;
    StateLabel* standing_;
    QPushButton* disable_;
    QSpinBox* delay_;
    QPushButton* read_;
    QLabel* granted_;
    Banner* blocked_;
    QLabel* notice_;
    QWidget* table_ = nullptr;
    QWidget* tablePlace_;

    int shown_ = -1;
    smartdevice::wire::Uid uid_;
    smartdevice::SharedDeviceSpec spec_;
    std::vector<ParameterRow*> rows_;
    /// Writes that are on their way, by parameter, with what a person has asked for since.
    std::map<int, std::optional<smartdevice::wire::Value>> waiting_;
};

}  // namespace kickstand::ui
