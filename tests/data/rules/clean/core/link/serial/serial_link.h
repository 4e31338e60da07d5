#pragma once

#include <QSerialPort>
#include "core/base/scheduler.h"
