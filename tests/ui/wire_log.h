#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <vector>

#include "core/link/tap.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/drive.h"

namespace kickstand::test {

/// What the host put on the wire: every drive block of every robot, in the order it went out. Written on the
/// engine thread, read by the test.
class WireLog final : public UsbTapObserver {
  public:
    void observe(const UsbTapRecord& record) override;

    /// Forgets what was: what comes now is an answer to what the test does next.
    void clear();
    std::vector<thunderbots::wire::DriveBlock> blocks(int robot) const;
    /// The newest one since clear().
    std::optional<thunderbots::wire::DriveBlock> last(int robot) const;
    /// Messages on the kick pipe since clear(), as robot numbers.
    std::vector<int> kicks() const;
    /// Their bytes after the pipe, as they went.
    std::vector<std::vector<std::uint8_t>> kickBytes() const;
    /// Messages on the test mode pipe since clear(): robot, class, target.
    std::vector<std::array<int, 3>> testModes() const;
    /// Messages on a robot's firmware request pipe since clear(), without the pipe.
    std::vector<std::vector<std::uint8_t>> firmware(int robot) const;
    std::uint64_t packets() const { return packets_; }

  private:
    void readState(ByteView packet);
    void readMessage(ByteView packet);

    mutable std::mutex mutex_;
    std::array<std::vector<thunderbots::wire::DriveBlock>, thunderbots::kRobots> blocks_;
    std::vector<int> kicks_;
    std::vector<std::vector<std::uint8_t>> kickBytes_;
    std::vector<std::array<int, 3>> testModes_;
    std::array<std::vector<std::vector<std::uint8_t>>, thunderbots::kRobots> firmware_;
    std::atomic<std::uint64_t> packets_{0};
};

}  // namespace kickstand::test
