#pragma once

#include <libusb-1.0/libusb.h>
#include "core/link/usb_link.h"
