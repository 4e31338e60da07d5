#include "core/base/good.h"
