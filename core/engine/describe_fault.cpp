#include "core/engine/describe_fault.h"

#include <QCoreApplication>

namespace kickstand {

using thunderbots::wire::Fault;
using thunderbots::wire::FaultSubject;

namespace {

struct FaultWords {
    Q_DECLARE_TR_FUNCTIONS(Fault)
};

}  // namespace

QString faultMeaning(const Fault& fault) {
    if (!fault.known) return FaultWords::tr("Unknown fault code");
    // The tables of the wire mark their texts for this context.
    return QCoreApplication::translate("Fault", fault.text);
}

QString faultText(const Fault& fault) {
    if (!fault.known) return FaultWords::tr("Unknown fault code %1").arg(fault.code);
    QString meaning = faultMeaning(fault);
    switch (fault.subject) {
        case FaultSubject::Motor:
            return FaultWords::tr("Motor %1: %2").arg(fault.index).arg(meaning);
        case FaultSubject::Radio:
            return FaultWords::tr("Radio %1: %2").arg(fault.index).arg(meaning);
        case FaultSubject::Robot:
            return FaultWords::tr("Robot %1: %2").arg(fault.index).arg(meaning);
        case FaultSubject::None:
            break;
    }
    return meaning;
}

}  // namespace kickstand
