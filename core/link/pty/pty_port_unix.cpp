#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <unistd.h>

#include "core/link/pty/pty_port.h"
#include "core/link/pty/pty_terminal.h"

namespace kickstand {
namespace {

namespace fs = std::filesystem;

class ServedPort final : public PtyPort, private ByteDeviceListener {
  public:
    ServedPort(Scheduler& scheduler, ByteDeviceModel& model, std::string link)
        : scheduler_(scheduler), model_(model), link_(std::move(link)) {}
    ~ServedPort() override {
        alive_.reset();
        model_.setListener(nullptr);
        withdraw();
    }
    ServedPort(const ServedPort&) = delete;
    ServedPort& operator=(const ServedPort&) = delete;

    Result<void> start() {
        model_.setListener(this);
        return model_.attached() ? offer() : Result<void>();
    }

    std::string terminal() const override { return terminal_ ? terminal_->name() : std::string(); }
    std::uint64_t lost() const override { return lost_; }

  private:
    Result<void> offer() {
        pty::TerminalEvents events;
        // What a terminal that has been withdrawn still had to say is void.
        const std::uint64_t offer = ++offer_;
        events.opened = [this, offer](Baud baud) {
            post(offer, [this, baud] {
                held_ = true;
                model_.lineOpened(baud);
            });
        };
        events.closed = [this, offer] {
            post(offer, [this] {
                held_ = false;
                model_.lineClosed();
            });
        };
        events.baudChanged = [this, offer](Baud baud) {
            post(offer, [this, baud] { model_.lineBaudChanged(baud); });
        };
        events.received = [this, offer](std::vector<std::uint8_t> bytes) {
            post(offer, [this, bytes = std::move(bytes)] { model_.hostSent(bytes); });
        };
        auto opened = pty::Terminal::open(std::move(events));
        if (!opened) return fail(std::move(opened.error()));
        terminal_ = std::move(*opened);
        auto linked = makeSymbolicLink();
        if (!linked) terminal_ = nullptr;
        return linked;
    }

    void withdraw() {
        if (terminal_ == nullptr) return;
        ++offer_;
        std::error_code error;
        if (!link_.empty() && fs::read_symlink(link_, error) == terminal_->name()) fs::remove(link_, error);
        terminal_ = nullptr;
        if (std::exchange(held_, false) && model_.attached()) model_.lineClosed();
    }

    Result<void> makeSymbolicLink() const {
        if (link_.empty()) return {};
        std::error_code error;
        const fs::file_status there = fs::symlink_status(link_, error);
        if (fs::exists(there)) {
            const bool ours =
                fs::is_symlink(there) && fs::read_symlink(link_, error).string().starts_with("/dev/pts/");
            if (!ours) return fail(Errc::BadArgument, link_, "exists");
            // A link that was left behind leads nowhere; one that leads to a terminal is served by another.
            if (fs::exists(link_, error)) return fail(Errc::ClaimedElsewhere, link_, "in use");
            fs::remove(link_, error);
        }
        if (::symlink(terminal_->name().c_str(), link_.c_str()) != 0)
            return fail(Errc::Io, link_, std::strerror(errno));
        return {};
    }

    /// Any thread.
    void post(std::uint64_t offer, std::function<void()> callback) {
        scheduler_.post([this, offer, alive = observedAlive_, callback = std::move(callback)] {
            if (!alive.expired() && offer == offer_ && model_.attached()) callback();
        });
    }

    void deviceSent(ByteView bytes) override {
        if (terminal_ != nullptr && !terminal_->send(bytes)) lost_ += bytes.size();
    }

    void attachedChanged(bool attached) override {
        if (!attached) return withdraw();
        // Where no terminal can be had now the device stays away, as a port with a broken cable would.
        if (terminal_ == nullptr) static_cast<void>(offer());
    }

    Scheduler& scheduler_;
    ByteDeviceModel& model_;
    const std::string link_;
    std::uint64_t offer_ = 0;
    bool held_ = false;
    std::uint64_t lost_ = 0;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
    const std::weak_ptr<const bool> observedAlive_ = alive_;
    std::unique_ptr<pty::Terminal> terminal_;
};

}  // namespace

Result<std::unique_ptr<PtyPort>> makePtyPort(Scheduler& scheduler, ByteDeviceModel& model, std::string link) {
    auto port = std::make_unique<ServedPort>(scheduler, model, std::move(link));
    if (auto started = port->start(); !started) return fail(std::move(started.error()));
    return port;
}

}  // namespace kickstand
