#pragma once

#include "core/base/bytes.h"
#include "core/framing/bit_field.h"
#include "core/thunderbots/wire/pipes.h"
