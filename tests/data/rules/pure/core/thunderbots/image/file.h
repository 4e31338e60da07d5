#pragma once
#include <vector>
#include <sys/stat.h>
