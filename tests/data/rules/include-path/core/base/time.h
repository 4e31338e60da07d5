#pragma once

#include "error.h"
#include "../base/hex.h"
#include "core/base/result.h"
#include <chrono>
