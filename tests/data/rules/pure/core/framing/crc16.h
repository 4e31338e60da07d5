#pragma once

#include <array>
#include <tl/expected.hpp>
#include <unistd.h>
