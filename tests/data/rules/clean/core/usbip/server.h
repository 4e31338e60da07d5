#pragma once

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"
