#pragma once

#include <memory>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/byte_link.h"
#include "core/link/byte_tap.h"

namespace kickstand {

/// Stands around a serial line and shows its observers everything that passes: the model is fed by this, and
/// so is a recording. Adds nothing to the link's behaviour; what arrives is observed before its receiver
/// hears of it, also where there is none.
class TappedByteLink final : public ByteLink {
  public:
    /// Takes `inner` over. `scheduler` is the one that it was made with.
    TappedByteLink(std::unique_ptr<ByteLink> inner, Scheduler& scheduler);

    /// Observers are told in the order they were added; each must outlive the link or be removed. Both may be
    /// called from inside observe(); the link itself must not be destroyed there. Link's thread.
    void addObserver(ByteTapObserver* observer);
    void removeObserver(ByteTapObserver* observer);

    void open(std::function<void(Result<ByteLinkInfo>)> done) override;
    void close(std::function<void()> done) override;
    Result<void> write(ByteView bytes) override;
    std::size_t waiting() const override { return inner_->waiting(); }
    void setBaud(Baud baud, std::function<void(Result<void>)> done) override;
    void setReceiver(std::function<void(ByteView)> receiver) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;

  private:
    void observe(ByteTapRecord record);

    Scheduler& scheduler_;
    std::vector<ByteTapObserver*> observers_;
    std::function<void(ByteView)> receiver_;
    std::function<void(bool)> presence_;
    bool open_ = false;
    bool observing_ = false;
    // Last, so that it goes first: its callbacks end here.
    std::unique_ptr<ByteLink> inner_;
};

}  // namespace kickstand
