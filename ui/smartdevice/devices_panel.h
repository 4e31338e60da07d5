#pragma once

#include "ui/shell/panel.h"
#include "ui/smartdevice/device_list.h"

class QLabel;
class QPushButton;

namespace kickstand::ui {

class DeviceChoice;

/// All boards of the kit and the ports that they are looked for at, with what to do where there is none.
class DevicesPanel final : public Panel {
    Q_OBJECT
  public:
    DevicesPanel(Bench& bench, DeviceChoice& choice, QWidget* parent = nullptr);

  private:
    void refresh();
    void refreshWords();
    std::vector<DeviceLine> linesOf(const smartdevice::Snapshot& snapshot) const;

    DeviceChoice& choice_;
    DeviceList* list_;
    QLabel* empty_;
    QLabel* remedy_;
    QPushButton* search_;
};

}  // namespace kickstand::ui
