#pragma once

#include <cstdint>
#include <sys/types.h>
#include <QString>
