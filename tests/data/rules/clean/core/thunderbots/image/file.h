#pragma once
#include <vector>
#include <tl/expected.hpp>
#include "core/base/time.h"
#include "core/framing/crc16.h"
