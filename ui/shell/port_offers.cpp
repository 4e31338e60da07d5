#include "ui/shell/port_offers.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>

#include "core/engine/describe_facts.h"
#include "ui/shell/connector.h"
#include "ui/shell/system_view.h"

namespace kickstand::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PortOffers)
};

}  // namespace

std::vector<PortOffer> offersOf(const BytePort& port, const SystemRegistry& systems) {
    const std::pair<const char*, SystemSnapshot> onSerialPorts[] = {
        {"smartdevice", smartdevice::Snapshot{}},
        {"coach", coach::Snapshot{}},
        {"motionplan", motionplan::Snapshot{}},
    };
    std::vector<PortOffer> offers;
    for (const auto& [protocol, snapshot] : onSerialPorts) {
        const SystemView* const view = systems.viewOf(snapshot);
        if (view == nullptr) continue;
        LinkUri uri{.scheme = "serial", .target = port.name, .options = {{"protocol", protocol}}};
        offers.push_back({view->name(), std::move(uri)});
    }
    return offers;
}

QString titleOf(const BytePort& port) {
    const QString name = QFileInfo(printable(port.name)).fileName();
    const QString description = printable(port.description.empty() ? port.manufacturer : port.description);
    return description.isEmpty() ? name : Words::tr("%1 \u00b7 %2").arg(name, description);
}

void addOffers(QMenu& menu, const BytePort& port, const SystemRegistry& systems, Connector& connector) {
    for (const PortOffer& offer : offersOf(port, systems)) {
        QAction* const action = menu.addAction(offer.system);
        action->setToolTip(QString::fromStdString(toString(offer.uri)));
        QObject::connect(action, &QAction::triggered, &connector,
                         [&connector, uri = offer.uri] { connector.connectTo(uri); });
    }
}

}  // namespace kickstand::ui
