#pragma once
#include "core/thunderbots/image/image.h"
#include "core/framing/crc16.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/controller.h"
#include "core/link/link.h"
