#pragma once

#include "core/base/time.h"

namespace kickstand {

/// How long the machine has slept (been suspended) since it started. A Scheduler's clock stands still
/// meanwhile, so that nothing else shows it. Always zero where the system does not tell. Any thread.
Duration timeAsleep();

}  // namespace kickstand
