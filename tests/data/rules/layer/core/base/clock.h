#pragma once

#include "core/framing/crc16.h"
