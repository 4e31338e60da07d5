#pragma once

#include <chrono>
#include <tl/expected.hpp>
#include "core/base/error.h"
