#pragma once

#include <QString>
#include "core/engine/messages.h"
