#pragma once

#include <QString>
#include <vector>

#include "core/engine/messages.h"

class QMenu;

namespace kickstand::ui {

class Connector;
class SystemRegistry;

/// One of the systems that may be at a serial port, and the link that takes the port for it.
struct PortOffer {
    QString system;  ///< "Motion plans".
    LinkUri uri;
};

/// What a port can be connected as: each system on serial ports that this window has a view of.
std::vector<PortOffer> offersOf(const BytePort& port, const SystemRegistry& systems);

/// "ttyACM0 · Arduino Micro".
QString titleOf(const BytePort& port);

/// Adds to a menu what a port can be connected as.
void addOffers(QMenu& menu, const BytePort& port, const SystemRegistry& systems, Connector& connector);

}  // namespace kickstand::ui
