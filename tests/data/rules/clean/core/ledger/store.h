#pragma once

#include <sqlite3.h>
#include "core/base/time.h"
