#pragma once

#include <QByteArray>
#include <QObject>
#include <QThread>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/link/byte_link.h"

class QSerialPort;
class QTimer;

namespace kickstand::serial {

/// What a port says, on the port's thread.
struct PortEvents {
    std::function<void(Result<ByteLinkInfo>)> opened;
    std::function<void(std::vector<std::uint8_t>)> received;
    std::function<void(std::size_t)> sent;  ///< So many bytes more were taken by the operating system.
    std::function<void()> lost;             ///< It hung up or was pulled out; it is closed by now.
    std::function<void()> closed;           ///< As close() asked.
    std::function<void()> appeared;         ///< A port that was lost or not there can be opened now.
};

/// A QSerialPort on a thread of its own. Its methods may be called from any thread and take effect on that
/// one, in order. Made and destroyed on one thread; destroying it closes the port and waits for the thread.
class Port {
  public:
    Port(std::string name, PortEvents events);
    ~Port();
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;

    void open(Baud baud);
    /// Lets what waits be sent for a moment, then closes.
    void close();
    void write(std::vector<std::uint8_t> bytes);
    void setBaud(Baud baud, std::function<void(Result<void>)> done);
    /// The receiver is through with bytes that it was handed. Without this the port stops reading after some
    /// time, and the other end has to wait, as on any line that nobody reads.
    void taken(std::size_t bytes);

  private:
    class Worker;

    void run(std::function<void(Worker&)> job);

    QThread thread_;
    Worker* worker_ = nullptr;  ///< Lives on the thread and is deleted at its end.
};

/// Whether a port of that name is there now. Any thread; may block.
bool portExists(const std::string& name);
/// What the system knows of a port ("Arduino Micro"); empty where it does not list it. May block.
std::string describePort(const std::string& name);

}  // namespace kickstand::serial
