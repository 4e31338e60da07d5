#pragma once

#include "core/thunderbots/types.h"
#include "core/thunderbots/controller.h"
#include "core/thunderbots/wire/drive.h"
#include "app/options.h"
