#pragma once

#include "core/base/scheduler.h"
#include "core/link/usb_types.h"
