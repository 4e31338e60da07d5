#pragma once

#include "qcustomplot.h"
#include "core/telemetry/time_series.h"
