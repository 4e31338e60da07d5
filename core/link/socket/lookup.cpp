#include "core/link/socket/lookup.h"

#include <thread>
#include <utility>

#include <asio/detail/socket_types.hpp>

namespace kickstand::socket {
namespace {

Result<std::vector<Protocol::endpoint>> lookUp(const std::string& host, const std::string& service,
                                               const std::string& subject) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_NUMERICSERV;
    addrinfo* list = nullptr;
    if (const int code = ::getaddrinfo(host.c_str(), service.c_str(), &hints, &list); code != 0)
        return fail(Errc::NoDevice, subject, ::gai_strerror(code));
    std::vector<Protocol::endpoint> endpoints;
    for (const addrinfo* entry = list; entry != nullptr; entry = entry->ai_next)
        endpoints.emplace_back(entry->ai_addr, entry->ai_addrlen, entry->ai_protocol);
    ::freeaddrinfo(list);
    return endpoints;
}

}  // namespace

Lookup::Lookup(IoCorePointer core, std::string subject, Found found)
    : core_(std::move(core)), subject_(std::move(subject)), found_(std::move(found)) {}

std::shared_ptr<Lookup> Lookup::begin(IoCorePointer core, const std::string& host, std::uint16_t port,
                                      std::string subject, Found found) {
    std::shared_ptr<Lookup> lookup(new Lookup(std::move(core), std::move(subject), std::move(found)));
    std::thread([lookup, host, service = std::to_string(port)] { lookup->run(host, service); }).detach();
    return lookup;
}

void Lookup::run(const std::string& host, const std::string& service) {
    auto result = lookUp(host, service, subject_);
    const std::lock_guard lock(mutex_);
    if (!found_) return;
    asio::post(core_->io, [found = std::move(found_), result = std::move(result)] { found(result); });
    found_ = nullptr;
    core_.reset();
}

void Lookup::abandon() {
    const std::lock_guard lock(mutex_);
    found_ = nullptr;
    core_.reset();
}

}  // namespace kickstand::socket
