#pragma once

#include <QCoreApplication>

namespace kickstand::ctl {

/// What kickstandctl says, in one translation context.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(kickstandctl)
};

}  // namespace kickstand::ctl
