#pragma once

#include "core/base/latch.h"
#include "core/link/usb_link.h"
#include "core/telemetry/store.h"
#include "core/thunderbots/controller.h"
#include "core/thunderbots/wire/drive.h"
#include "core/engine/messages.h"
