#pragma once

#include <QString>

#include <tl/expected.hpp>

#include "core/base/error.h"
#include "core/engine/describe.h"

namespace kickstand::ctl {

/// What the shell is told.
enum ExitCode : int {
    kDone = 0,
    kFailed = 1,    ///< The robot or the link refused or failed.
    kBadUsage = 2,  ///< What was typed cannot be meant.
};

/// Why a command ends without being done: one line for a person, a name for a script.
struct Failure {
    ExitCode exitCode = kFailed;
    Description text;
    QString code;  ///< As name(Errc) has it, or "usage".
};

template <class T>
using Expected = tl::expected<T, Failure>;
using Outcome = Expected<void>;

/// What was typed cannot be meant: exit 2.
tl::unexpected<Failure> badUsage(const QString& what, const QString& remedy);
/// An error of the engine or a link: exit 1.
tl::unexpected<Failure> failed(const Error& error);
/// An error about something that was typed: exit 2.
tl::unexpected<Failure> refusedInput(const Error& error);

}  // namespace kickstand::ctl
