#pragma once

#include "core/thunderbots/types.h"
