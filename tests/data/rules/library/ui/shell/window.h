#pragma once

#include "qcustomplot.h"
#include <SDL2/SDL.h>
#include <QtSerialPort/QSerialPortInfo>
