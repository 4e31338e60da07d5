#include "outside.h"  // TODO: a build's own files are not looked at
