#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/kickstand-sim/control_desk.h"
#include "app/kickstand-sim/line_reader.h"
#include "core/link/socket/sockets.h"

namespace kickstand::sim {

/// The desk's local socket: a few clients at once, each a line at a time. A client that does not read its
/// answers is closed, as is one too many. On the scheduler's thread.
class ControlServer {
  public:
    static constexpr std::size_t kMaxClients = 16;
    /// Bytes of answers that wait for a client; past it the client is closed.
    static constexpr std::size_t kMaxUnsent = std::size_t{1} << 20;

    /// Hears, in words, who was closed and why.
    using Log = std::function<void(const std::string& line)>;

    /// Listens at `path`; the file is removed when the server is destroyed. Scheduler and desk must outlive
    /// it. Errors: those of Sockets::listenLocal().
    static Result<std::unique_ptr<ControlServer>> serve(Scheduler& scheduler, const std::string& path,
                                                        ControlDesk& desk, Log log);
    ControlServer(const ControlServer&) = delete;
    ControlServer& operator=(const ControlServer&) = delete;

    std::size_t clients() const { return clients_.size(); }

  private:
    struct Client {
        std::unique_ptr<ByteStream> stream;
        LineReader lines{kMaxRequestBytes};
        bool closing = false;
    };

    ControlServer(Scheduler& scheduler, ControlDesk& desk, Log log);

    void accepted(std::unique_ptr<ByteStream> stream);
    void received(std::uint64_t id, ByteView bytes);
    void reply(Client& client, const QByteArray& line);
    void closeLater(std::uint64_t id);

    Scheduler& scheduler_;
    ControlDesk& desk_;
    const Log log_;
    Sockets sockets_;
    std::map<std::uint64_t, Client> clients_;
    std::uint64_t lastId_ = 0;
    std::unique_ptr<Listener> listener_;
    /// What is still to be called finds out by it that the server is gone.
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace kickstand::sim
