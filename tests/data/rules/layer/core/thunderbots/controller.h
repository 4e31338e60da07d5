#pragma once

#include "core/thunderbots/types.h"
#include "core/coach/types.h"
#include "core/engine/engine.h"
#include "core/thunderbots/sim/dongle.h"
#include "core/telemetry/store.h"
