#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/engine/messages.h"
#include "ui/widgets/state_label.h"

namespace kickstand::ui {

class Bench;
class Panel;

/// Where a panel stands on the first day. Those of one place are tabs of it.
enum class PanelPlace {
    Side,    ///< The column at the left, from top to bottom.
    Work,    ///< The large place at the top.
    Aside,   ///< A narrow column at the right of it.
    Below,   ///< Under these two, across.
    Bottom,  ///< Under everything.
};

/// What the shell must know of a panel before there is one.
struct PanelEntry {
    QString id;  ///< Stable: layouts are remembered by it.
    QString title;
    QString helpPage;  ///< A page of resources/help.
    PanelPlace place = PanelPlace::Work;
    std::function<Panel*(Bench&)> make;
};

/// A link that the window offers although nothing was found.
struct LinkOffer {
    QString title;
    QString invitation;  ///< On a button.
    QString explanation;
    LinkUri uri;
};

/// A state in the bar at the top.
struct StateText {
    Tone tone = Tone::Idle;
    QString text;
    QString strong;
};

/// A quantity that can be shown in one of several units, as a person likes it. The first is the usual one.
struct UnitChoice {
    QString id;    ///< "wheelSpeed": the choice is kept under it.
    QString text;  ///< "Wheel speeds"
    QStringList units;
};

/// Something that stays dangerous when the program ends.
struct Hazard {
    QString text;    ///< "robot 3: 212 V on its capacitor".
    TimePoint at{};  ///< When that was known.
    bool stale = false;
    bool moves = false;  ///< A robot that goes its own way, and not a charged capacitor.
};

/// What the shell shows of a system without knowing what it is. One for each system.
class SystemView {
  public:
    virtual ~SystemView() = default;

    virtual QString name() const = 0;
    virtual std::vector<PanelEntry> panels() const = 0;
    virtual std::vector<LinkOffer> offers() const = 0;
    virtual std::vector<UnitChoice> unitChoices() const { return {}; }
    /// How high the panels of the work are at first.
    virtual int workHeight() const { return 360; }

    /// Whether the snapshot is of this system.
    virtual bool owns(const SystemSnapshot& system) const = 0;
    /// Whether anything moves, charges or executes.
    virtual bool isMoving(const SystemSnapshot& system) const = 0;
    /// The same, or is armed.
    virtual bool isActive(const SystemSnapshot& system) const = 0;
    /// Why a STOP cannot be taken back yet, with what to do; empty where it can.
    virtual QString rearmHindrance(const SystemSnapshot& system) const {
        Q_UNUSED(system)
        return {};
    }
    /// How the link stands, first, and other states that matter everywhere.
    virtual std::vector<StateText> states(const SessionSnapshot& session) const = 0;
    /// Why the link does not run, where it does not.
    virtual const Error* obstacle(const SystemSnapshot& system) const = 0;
    /// Short facts for the bar at the bottom.
    virtual QStringList facts(const SessionSnapshot& session) const = 0;
    virtual std::vector<Hazard> hazards(const SystemSnapshot& system) const = 0;
    /// "sixteen virtual robots".
    virtual QString simulatedText(const LinkUri& uri) const = 0;
    /// The units that an action of the simulator is done to, as a person has chosen them.
    virtual std::vector<int> chosenUnits() const = 0;
    /// An action of the simulator in words, and the values that have names; without such a number is asked
    /// for.
    virtual QString actionText(const SimAction& action) const = 0;
    virtual std::vector<std::pair<QString, double>> actionChoices(const SimAction& action) const = 0;
    /// A unit in words: "Robot 3".
    virtual QString unitText(int unit) const = 0;
    /// Where more is said about an event, as Bench::goTo() takes it; empty where nowhere is.
    virtual QString placeOf(const SystemEvent& event) const {
        Q_UNUSED(event)
        return {};
    }
};

/// The systems of this program, in the order they are shown.
class SystemRegistry {
  public:
    void add(std::unique_ptr<SystemView> view) { views_.push_back(std::move(view)); }
    const std::vector<std::unique_ptr<SystemView>>& views() const { return views_; }
    const SystemView* viewOf(const SystemSnapshot& system) const {
        for (const auto& view : views_) {
            if (view->owns(system)) return view.get();
        }
        return nullptr;
    }

  private:
    std::vector<std::unique_ptr<SystemView>> views_;
};

}  // namespace kickstand::ui
