#pragma once

#include "core/base/time.h"
#include "core/telemetry/time_series.h"
