#pragma once

#include "core/fifth/wire/frame.h"
#include "core/thunderbots/types.h"
