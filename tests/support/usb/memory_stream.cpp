#include "tests/support/usb/memory_stream.h"

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <vector>

namespace kickstand::testing {
namespace {

/// One end, as the other sees it.
struct End {
    std::optional<ByteStream::Events> events;  ///< Once started.
    bool open = true;                          ///< Its owner has not closed it.
    bool told = false;                         ///< Its owner has heard the end.
    bool moving = false;                       ///< A piece is under way to it.
    std::vector<std::uint8_t> coming;          ///< Sent to it, and not received.
};

class Wire final : public std::enable_shared_from_this<Wire> {
  public:
    Wire(Scheduler& scheduler, const MemoryStreamOptions& options)
        : scheduler_(scheduler), options_(options), random_(options.seed) {}

    void start(std::size_t side, ByteStream::Events events) {
        ends_.at(side).events = std::move(events);
        move(side);
    }
    void send(std::size_t side, ByteView bytes) {
        End& peer = ends_.at(1 - side);
        if (!ends_.at(side).open || !peer.open) return;
        peer.coming.insert(peer.coming.end(), bytes.begin(), bytes.end());
        move(1 - side);
    }
    std::size_t unsent(std::size_t side) const { return ends_.at(1 - side).coming.size(); }
    void close(std::size_t side) {
        ends_.at(side).open = false;
        ends_.at(side).coming.clear();
        move(1 - side);
    }

  private:
    /// Has the next piece brought to an end, or the word that there is none any more.
    void move(std::size_t side) {
        End& end = ends_.at(side);
        const bool something = !end.coming.empty() || !ends_.at(1 - side).open;
        if (!end.open || !end.events || end.told || end.moving || !something) return;
        end.moving = true;
        scheduler_.callAfter(options_.delay, [self = shared_from_this(), side] { self->arrive(side); });
    }

    void arrive(std::size_t side) {
        End& end = ends_.at(side);
        end.moving = false;
        if (!end.open) return;
        const auto events = *end.events;
        if (end.coming.empty()) {
            end.told = true;
            return events.closed(Error{.code = Errc::Disconnected, .subject = "connection"});
        }
        const std::size_t size =
            std::min<std::size_t>(1 + random_() % options_.largestPiece, end.coming.size());
        const auto last = end.coming.begin() + static_cast<std::ptrdiff_t>(size);
        const std::vector<std::uint8_t> piece(end.coming.begin(), last);
        end.coming.erase(end.coming.begin(), last);
        events.received(piece);
        move(side);
    }

    Scheduler& scheduler_;
    const MemoryStreamOptions options_;
    std::mt19937 random_;
    std::array<End, 2> ends_;
};

class MemoryStream final : public ByteStream {
  public:
    MemoryStream(std::shared_ptr<Wire> wire, std::size_t side) : wire_(std::move(wire)), side_(side) {}
    ~MemoryStream() override { wire_->close(side_); }
    MemoryStream(const MemoryStream&) = delete;
    MemoryStream& operator=(const MemoryStream&) = delete;

    void start(Events events) override { wire_->start(side_, std::move(events)); }
    void send(ByteView bytes) override { wire_->send(side_, bytes); }
    std::size_t unsent() const override { return wire_->unsent(side_); }
    void close() override { wire_->close(side_); }

  private:
    const std::shared_ptr<Wire> wire_;
    const std::size_t side_;
};

}  // namespace

std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> makeMemoryStreams(
    Scheduler& scheduler, const MemoryStreamOptions& options) {
    auto wire = std::make_shared<Wire>(scheduler, options);
    return {std::make_unique<MemoryStream>(wire, 0), std::make_unique<MemoryStream>(wire, 1)};
}

}  // namespace kickstand::testing
