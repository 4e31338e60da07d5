#pragma once

#include <QSerialPort>
#include <libusb.h>
