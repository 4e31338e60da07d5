#include "app/kickstand-sim/control_server.h"

namespace kickstand::sim {

ControlServer::ControlServer(Scheduler& scheduler, ControlDesk& desk, Log log)
    : scheduler_(scheduler), desk_(desk), log_(std::move(log)), sockets_(scheduler) {}

Result<std::unique_ptr<ControlServer>> ControlServer::serve(Scheduler& scheduler, const std::string& path,
                                                            ControlDesk& desk, Log log) {
    std::unique_ptr<ControlServer> server(new ControlServer(scheduler, desk, std::move(log)));
    auto listener = server->sockets_.listenLocal(
        path, [raw = server.get()](std::unique_ptr<ByteStream> stream) { raw->accepted(std::move(stream)); });
    if (!listener) return fail(listener.error());
    server->listener_ = std::move(*listener);
    return server;
}

void ControlServer::accepted(std::unique_ptr<ByteStream> stream) {
    if (clients_.size() == kMaxClients) {
        log_("control: one client too many was closed");
        return;
    }
    const std::uint64_t id = ++lastId_;
    Client& client = clients_[id];
    client.stream = std::move(stream);
    client.stream->start({.received = [this, id](ByteView bytes) { received(id, bytes); },
                          .closed = [this, id](const Error&) { closeLater(id); }});
}

void ControlServer::received(std::uint64_t id, ByteView bytes) {
    const auto found = clients_.find(id);
    if (found == clients_.end()) return;
    Client& client = found->second;
    client.lines.take(
        bytes, [&](ByteView line) { reply(client, client.closing ? QByteArray() : desk_.answer(line)); },
        [&] { reply(client, ControlDesk::answerToTooLong()); });
    if (client.closing) closeLater(id);
}

void ControlServer::reply(Client& client, const QByteArray& line) {
    if (client.closing) return;
    const QByteArray whole = line + '\n';
    client.stream->send(
        {reinterpret_cast<const std::uint8_t*>(whole.constData()), static_cast<std::size_t>(whole.size())});
    if (client.stream->unsent() <= kMaxUnsent) return;
    client.closing = true;
    log_("control: a client that does not read its answers was closed");
}

void ControlServer::closeLater(std::uint64_t id) {
    // Never from inside the stream's own call.
    scheduler_.post([this, id, alive = std::weak_ptr(alive_)] {
        if (!alive.expired()) clients_.erase(id);
    });
}

}  // namespace kickstand::sim
