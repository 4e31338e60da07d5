#pragma once

#include "core/thunderbots/snapshot.h"
#include "ui/shell/system_view.h"
#include "ui/thunderbots/kick_settings.h"
#include "ui/thunderbots/robot_choice.h"

namespace kickstand {
class Ledger;
}

namespace kickstand::ui {

class DriveControl;

/// The thunderbots part of a session's snapshot; null where it is of another system, or there is none.
const thunderbots::Snapshot* snapshotOf(const SessionSnapshot* session);

/// What the shell shows of the thunderbots system, and its panels.
class ThunderbotsView final : public SystemView {
  public:
    /// `ledger` keeps what is read from robots; it must outlive every panel.
    explicit ThunderbotsView(Ledger& ledger);
    ~ThunderbotsView() override;

    QString name() const override;
    std::vector<PanelEntry> panels() const override;
    std::vector<LinkOffer> offers() const override;
    std::vector<UnitChoice> unitChoices() const override;
    bool owns(const SystemSnapshot& system) const override;
    bool isMoving(const SystemSnapshot& system) const override;
    bool isActive(const SystemSnapshot& system) const override;
    QString rearmHindrance(const SystemSnapshot& system) const override;
    std::vector<StateText> states(const SessionSnapshot& session) const override;
    const Error* obstacle(const SystemSnapshot& system) const override;
    QStringList facts(const SessionSnapshot& session) const override;
    std::vector<Hazard> hazards(const SystemSnapshot& system) const override;
    QString simulatedText(const LinkUri& uri) const override;
    std::vector<int> chosenUnits() const override;
    QString actionText(const SimAction& action) const override;
    std::vector<std::pair<QString, double>> actionChoices(const SimAction& action) const override;
    QString unitText(int unit) const override;
    QString placeOf(const SystemEvent& event) const override;
    int workHeight() const override;

    RobotChoice& choice() const { return *choice_; }

  private:
    Ledger& ledger_;
    std::unique_ptr<RobotChoice> choice_ = std::make_unique<RobotChoice>();
    std::unique_ptr<KickSettings> kick_ = std::make_unique<KickSettings>();
    std::unique_ptr<DriveControl> drive_;
};

}  // namespace kickstand::ui
