#pragma once

#include "core/smartdevice/snapshot.h"
#include "ui/shell/system_view.h"

namespace kickstand::ui {

class DeviceChoice;

/// The smart devices' part of a session's snapshot; null where it is of another system, or there is none.
const smartdevice::Snapshot* boardsOf(const SessionSnapshot* session);

/// What the shell shows of smart devices, and their panels.
class SmartdeviceView final : public SystemView {
  public:
    SmartdeviceView();
    ~SmartdeviceView() override;

    QString name() const override;
    std::vector<PanelEntry> panels() const override;
    std::vector<LinkOffer> offers() const override;
    int workHeight() const override;
    bool owns(const SystemSnapshot& system) const override;
    bool isMoving(const SystemSnapshot& system) const override;
    bool isActive(const SystemSnapshot& system) const override;
    std::vector<StateText> states(const SessionSnapshot& session) const override;
    const Error* obstacle(const SystemSnapshot& system) const override;
    QStringList facts(const SessionSnapshot& session) const override;
    std::vector<Hazard> hazards(const SystemSnapshot& system) const override;
    QString simulatedText(const LinkUri& uri) const override;
    std::vector<int> chosenUnits() const override;
    QString actionText(const SimAction& action) const override;
    std::vector<std::pair<QString, double>> actionChoices(const SimAction& action) const override;
    QString unitText(int unit) const override;

  private:
    std::unique_ptr<DeviceChoice> choice_;
};

}  // namespace kickstand::ui
