#pragma once

#include "core/link/usb_device_model.h"
#include "core/thunderbots/wire/drive.h"
