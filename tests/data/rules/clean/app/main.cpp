#include "core/engine/engine.h"
#include "core/link/usb/libusb_link.h"
#include "core/thunderbots/sim/dongle.h"
#include "ui/shell/window.h"
