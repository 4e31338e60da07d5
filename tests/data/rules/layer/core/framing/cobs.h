#pragma once

#include "core/link/usb_types.h"
