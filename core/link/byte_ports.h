#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/link/byte_link.h"

namespace kickstand {

/// A serial port that there is, found without opening it.
struct BytePort {
    std::string name;          ///< What it is opened by: "/dev/ttyACM0".
    std::string description;   ///< "Arduino Micro"; may be empty.
    std::string manufacturer;  ///< May be empty.
    std::string serialNumber;  ///< May be empty.
    std::uint16_t vendor = 0;  ///< USB vendor and product; 0 where it is not on USB.
    std::uint16_t product = 0;

    friend bool operator==(const BytePort&, const BytePort&) = default;
};

/// Which serial ports there are, now and as they come and go. The scheduler's thread; what may block happens
/// on another.
class BytePorts {
  public:
    virtual ~BytePorts() = default;
    /// Tells every port there is, soon and then after each change. One listener; an empty one ends it.
    virtual void watch(std::function<void(const std::vector<BytePort>&)> changed) = 0;
    /// A link to one of them, not yet open. Never null: a port that is not there is open()'s NoDevice.
    virtual std::unique_ptr<ByteLink> makeLink(const std::string& name, Baud baud) = 0;
};

}  // namespace kickstand
