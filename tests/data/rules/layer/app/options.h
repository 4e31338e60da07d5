#pragma once

#include "tests/support/clock.h"
