#pragma once

#include "core/thunderbots/types.h"
#include "core/thunderbots/sim/dongle.h"
#include "ui/shell/window.h"
