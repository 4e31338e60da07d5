#pragma once

#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/model.h"
