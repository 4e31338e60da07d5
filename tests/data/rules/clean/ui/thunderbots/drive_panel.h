#pragma once

#include <QWidget>
#include "core/base/time.h"
#include "core/engine/engine.h"
#include "core/telemetry/store.h"
#include "core/thunderbots/snapshot.h"
#include "core/thunderbots/wire/kick_timing.h"
#include "ui/widgets/slider.h"
