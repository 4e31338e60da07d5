#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/link/socket/io_core.h"

namespace kickstand::socket {

/// One look-up of a name. Nothing can end the operating system's own, which may last longer than the program
/// wants to live: so it has a thread to itself, which after abandon() touches nothing but this object.
/// (Asio's resolver would need its categories of errors even while the program destroys its statics.)
class Lookup {
  public:
    using Found = std::function<void(Result<std::vector<Protocol::endpoint>>)>;

    /// Begins it. `found` is called once on the sockets' thread, unless abandoned: with the addresses of
    /// `host`, or NoDevice, naming `subject`, with the system's word. The sockets' thread.
    static std::shared_ptr<Lookup> begin(IoCorePointer core, const std::string& host, std::uint16_t port,
                                         std::string subject, Found found);
    /// Calls nobody from here on. The sockets' thread.
    void abandon();

  private:
    Lookup(IoCorePointer core, std::string subject, Found found);
    void run(const std::string& host, const std::string& service);

    std::mutex mutex_;
    IoCorePointer core_;
    std::string subject_;
    Found found_;
};

}  // namespace kickstand::socket
