#pragma once

#include <QJsonObject>
#include <QStringList>
#include <vector>

#include "core/base/bytes.h"
#include "core/link/sim_control.h"

namespace kickstand::sim {

/// A word that stands for a value of an action ("run" for 3 of "e-stop"), or an action of its own that is
/// another one with its value given ("kill" for "dead" 1).
struct ValueWord {
    const char* action;  ///< The action's name.
    const char* word;
    double value;
};

/// Simulated units of one family, as the control socket shows and handles them. Each family implements it in
/// a file of its own. On the simulator's thread.
class Simulation {
  public:
    virtual ~Simulation() = default;

    /// "thunderbots": the family's name on the command line.
    virtual const char* family() const = 0;
    /// "a Thunderbots dongle and robots 0, 3, 5": what there is, for a person.
    virtual QString description() const = 0;
    /// "robot": what one unit is called, which is the key of its number as well.
    virtual const char* unitName() const = 0;
    /// The numbers of the units that there are, ascending.
    virtual std::vector<int> units() const = 0;
    virtual SimControl& control() = 0;
    /// What values may be called.
    virtual std::vector<ValueWord> valueWords() const = 0;
    /// Further actions that are nothing but a name for another one's value.
    virtual std::vector<ValueWord> shortcuts() const = 0;

    /// What the whole received and is doing now, without its units.
    virtual QJsonObject show() = 0;
    /// The same of one of the units().
    virtual QJsonObject showUnit(int unit) const = 0;

    /// Bytes of the flash memory that each unit has; 0 for none.
    virtual std::uint32_t flashBytes() const = 0;
    /// Copies from it. The unit is one of the units() and the range lies within.
    virtual void readFlash(int unit, std::uint32_t address, ByteSpan into) const = 0;
};

/// What carries simulated units to host programs. On the simulator's thread.
class Carrier {
  public:
    virtual ~Carrier() = default;
    /// Where it is and what it has carried; stable keys.
    virtual QJsonObject report() const = 0;
    /// Lines that tell a person how a host program gets there.
    virtual QStringList howToReach() const = 0;
};

}  // namespace kickstand::sim
