#pragma once

#include <QCoreApplication>

namespace kickstand::sim {

/// What kickstand-sim says, in one translation context.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(kickstand_sim)
};

}  // namespace kickstand::sim
