#pragma once

#include "core/framing/bit_field.h"
#include "core/link/usb_types.h"
#include "core/coach/wire/frame.h"
