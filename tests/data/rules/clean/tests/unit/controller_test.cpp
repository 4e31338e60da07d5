#include <gtest/gtest.h>

#include "core/thunderbots/controller.h"
#include "core/thunderbots/sim/dongle.h"
#include "tests/support/clock.h"
