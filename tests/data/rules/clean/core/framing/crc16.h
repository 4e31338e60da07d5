#pragma once

#include <array>
#include "core/base/bytes.h"
#include "core/framing/inline_bytes.h"
