#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/coach/sim/rival_sim.h"
#include "core/coach/sim/towrp_sim.h"
#include "core/coach/sim/xbee_sim.h"
#include "core/link/link_uri.h"
#include "core/link/sim_control.h"

namespace kickstand::coach::sim {

/// Which radios there are. The defaults are the module of a COACH of team 5, its own boat and two others.
struct CoachSimOptions {
    std::vector<std::uint16_t> modules{0xBC05};  ///< The addresses of the modules with a serial line.
    bool fresh = false;                          ///< Whether the modules are as they come from the factory.
    std::vector<wire::Team> boats{3, 5, 7};
    std::vector<wire::Team> rivals;      ///< Simulated COACHes.
    double loss = 0;                     ///< Of packets, 0 to 1.
    std::map<wire::Team, double> lossy;  ///< Of the packets from and to these boats, besides.
    std::uint32_t seed = 1;
    Duration fall = std::chrono::seconds(5);  ///< How often a crew's morale falls; never where it is zero.
};

/// The options of a `sim:coach` URI: `address=0xBC05`, `fresh=1`, `towrps=3,5,7`, `coaches=4`, `loss=0.05`,
/// `lossy=7:0.3` (with commas between several), `seed=1`, `fall=5` (seconds). Errors: UnknownName for another
/// option, OutOfRange with the bounds, BadArgument with what was given. Any thread.
Result<CoachSimOptions> parseSimOptions(const LinkUri& uri);

/// Simulated radio modules with a serial line, and the boats and COACHes that they hear. What a hand can do:
/// to a boat `morale`, `dead`, `boat-loss`; to all of it `loss`, `plugged`, `restart`. One thread, the
/// scheduler's.
class CoachSim final : public SimControl {
  public:
    CoachSim(Scheduler& scheduler, const CoachSimOptions& options);

    std::size_t modules() const { return modules_.size(); }
    XbeeSim& module(std::size_t index) { return *modules_[index]; }
    RadioMedium& medium() { return medium_; }
    const std::vector<std::unique_ptr<TowrpSim>>& boats() const { return boats_; }
    const std::vector<std::unique_ptr<RivalSim>>& rivals() const { return rivals_; }
    /// Null where there is none of that team.
    TowrpSim* boat(int team) const;

    std::vector<SimAction> actions() const override;
    std::vector<int> units() const override;
    Result<void> perform(std::string_view action, int unit, double value) override;
    std::optional<double> value(std::string_view action, int unit) const override;

  private:
    Result<void> performOne(std::string_view action, TowrpSim& boat, double value);

    RadioMedium medium_;
    std::vector<std::unique_ptr<XbeeSim>> modules_;
    std::vector<std::unique_ptr<TowrpSim>> boats_;
    std::vector<std::unique_ptr<RivalSim>> rivals_;
};

}  // namespace kickstand::coach::sim
