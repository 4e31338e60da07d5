#pragma once

#include "core/base/scheduler.h"
#include "core/link/sim_control.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/sim/robot.h"
