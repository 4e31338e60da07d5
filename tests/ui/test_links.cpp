#include "tests/ui/test_links.h"

#include <utility>

#include "core/link/loopback/loopback_usb_link.h"
#include "core/link/tapped_usb_link.h"
#include "core/thunderbots/sim/thunderbots_sim.h"

namespace kickstand::test {

namespace {

using thunderbots::sim::parseSimOptions;
using thunderbots::sim::RadioPace;
using thunderbots::sim::ThunderbotsSim;
using thunderbots::sim::ThunderbotsSimOptions;

class TestLinks final : public LinkProvider {
  public:
    explicit TestLinks(std::shared_ptr<LinkBoard> board) : board_(std::move(board)) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override {
        {
            const std::lock_guard lock(board_->mutex);
            board_->opened.push_back(toString(uri));
        }
        ThunderbotsSimOptions options;
        if (uri.isSimulated()) {
            const auto parsed = parseSimOptions(uri);
            if (!parsed) return fail(parsed.error());
            options = *parsed;
        }
        // Tests wait for what happens, not for how long it takes.
        options.pace = RadioPace::Ideal;
        options.noise = false;
        auto sim = std::make_shared<ThunderbotsSim>(scheduler, options);
        LoopbackOptions loopback;
        loopback.everyFrame = true;
        auto tapped = std::make_unique<TappedUsbLink>(
            std::make_unique<LoopbackUsbLink>(scheduler, sim->device(), loopback), scheduler);
        tapped->addObserver(&board_->wire);
        ProvidedUsbLink provided;
        provided.link = std::move(tapped);
        provided.sim = &sim->control();
        provided.keepAlive = std::move(sim);
        return provided;
    }

    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([board = board_, found = std::move(found)] {
            FoundHardware hardware;
            {
                const std::lock_guard lock(board->mutex);
                hardware = board->found;
            }
            found(std::move(hardware));
        });
    }

  private:
    std::shared_ptr<LinkBoard> board_;
};

}  // namespace

void LinkBoard::setFound(std::vector<FoundDevice> devices, std::vector<BytePort> ports) {
    const std::lock_guard lock(mutex);
    found = {std::move(devices), std::move(ports)};
}

std::vector<std::string> LinkBoard::openedLinks() {
    const std::lock_guard lock(mutex);
    return opened;
}

std::unique_ptr<LinkProvider> makeTestLinks(std::shared_ptr<LinkBoard> board) {
    return std::make_unique<TestLinks>(std::move(board));
}

}  // namespace kickstand::test
