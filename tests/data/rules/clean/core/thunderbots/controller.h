#pragma once

#include "core/base/latch.h"
#include "core/framing/crc16.h"
#include "core/link/usb_link.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/types.h"
