#pragma once

#include "core/thunderbots/wire/drive.h"
