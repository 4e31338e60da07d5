#pragma once

#include "core/base/time.h"
#include "core/capture/file.h"
