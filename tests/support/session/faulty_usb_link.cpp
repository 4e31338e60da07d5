#include "tests/support/session/faulty_usb_link.h"

#include <algorithm>
#include <utility>

namespace kickstand::testing {

FaultyUsbLink::FaultyUsbLink(std::unique_ptr<UsbLink> inner, Scheduler& scheduler, const FaultPlan& plan,
                             std::function<void(std::uint64_t)> step)
    : scheduler_(scheduler),
      plan_(plan),
      step_(std::move(step)),
      random_(plan.seed),
      inner_(std::move(inner)) {
    inner_->setPresenceListener([this](bool present) {
        if (!present) {
            open_ = false;
            endHeld(UsbStatus::NoDevice);
        }
        if (const auto listener = presence_) listener(present);
    });
}

FaultyUsbLink::~FaultyUsbLink() = default;

void FaultyUsbLink::countStep() {
    ++steps_;
    if (step_) step_(steps_);
}

bool FaultyUsbLink::happens(double probability) {
    return probability > 0 && static_cast<double>(random_() >> 11) * 0x1p-53 < probability;
}

std::size_t FaultyUsbLink::below(std::size_t bound) {
    return bound == 0 ? 0 : static_cast<std::size_t>(random_() % bound);
}

void FaultyUsbLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    countStep();
    inner_->open([this, done = std::move(done)](Result<UsbDeviceInfo> opened) {
        open_ = opened.has_value();
        done(std::move(opened));
    });
}

void FaultyUsbLink::close(std::function<void()> done) {
    open_ = false;
    inner_->close([this, done = std::move(done)] {
        endHeld(UsbStatus::Cancelled);
        if (done) done();
    });
}

void FaultyUsbLink::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    countStep();
    inner_->control(setup, data, deadline, std::move(done));
}

void FaultyUsbLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    countStep();
    inner_->clearHalt(endpoint, std::move(done));
}

Result<UsbTransferId> FaultyUsbLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    countStep();
    if (open_ && happens(plan_.stall)) {
        tellLater(endpoint, std::chrono::milliseconds(1), {std::move(done), UsbStatus::Stalled, {}, 0});
        return ++lastId_;
    }
    const UsbTransferId id = lastId_ + 1;
    if (open_ && refusing_) {
        refused_[id] = {endpoint, std::move(done)};
        return ++lastId_;
    }
    auto submitted = inner_->submitOut(endpoint, data,
                                       [this, id, done = std::move(done)](const UsbCompletion& completion) {
                                           innerIds_.erase(id);
                                           done(completion);
                                       });
    if (!submitted) return submitted;
    innerIds_[id] = *submitted;
    return ++lastId_;
}

Result<UsbTransferId> FaultyUsbLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    countStep();
    if (!open_) return fail(Errc::NotConnected, "link");
    const UsbTransferId id = ++lastId_;
    auto& copies = copies_[endpoint];
    if (!copies.empty()) {
        const std::size_t actual = copies.front().size();
        tellLater(endpoint, Duration::zero(),
                  {std::move(done), UsbStatus::Completed, std::move(copies.front()), actual});
        copies.pop_front();
        return id;
    }
    ask(endpoint, size, done, id);
    return id;
}

void FaultyUsbLink::ask(std::uint8_t endpoint, std::size_t size, const UsbCallback& done, UsbTransferId id) {
    const auto submitted =
        inner_->submitIn(endpoint, size, [this, endpoint, size, done, id](const UsbCompletion& completion) {
            innerIds_.erase(id);
            arrived(endpoint, size, done, id, completion);
        });
    if (submitted) {
        innerIds_[id] = *submitted;
    } else {
        tellLater(endpoint, Duration::zero(), {done, UsbStatus::NoDevice, {}, 0});
    }
}

void FaultyUsbLink::arrived(std::uint8_t endpoint, std::size_t size, const UsbCallback& done,
                            UsbTransferId id, const UsbCompletion& completion) {
    Held held{done, completion.status, {completion.data.begin(), completion.data.end()}, completion.actual};
    if (completion.status == UsbStatus::Completed) {
        if (happens(plan_.drop)) {
            ask(endpoint, size, done, id);
            return;
        }
        if (happens(plan_.stall)) {
            held.status = UsbStatus::Stalled;
            held.data.clear();
        }
        if (happens(plan_.duplicate)) copies_[endpoint].push_back(held.data);
        if (happens(plan_.truncate)) held.data.resize(below(held.data.size()));
        if (!held.data.empty() && happens(plan_.corrupt))
            held.data[below(held.data.size())] = static_cast<std::uint8_t>(random_());
        held.actual = held.data.size();
    }
    const bool late = happens(plan_.delay);
    const auto most = static_cast<std::size_t>(plan_.longestDelay.count());
    tellLater(endpoint, late ? Duration(below(most)) : Duration::zero(), std::move(held));
}

void FaultyUsbLink::tellLater(std::uint8_t endpoint, Duration delay, Held held) {
    // Packets of an endpoint keep their order, however late they are.
    TimePoint& until = toldUntil_[endpoint];
    until = std::max(until, scheduler_.now() + delay);
    held_[endpoint].push_back(std::move(held));
    scheduler_.callAt(until, [this, endpoint, alive = std::weak_ptr(alive_)] {
        if (alive.expired() || held_[endpoint].empty()) return;
        const Held next = std::move(held_[endpoint].front());
        held_[endpoint].pop_front();
        next.done({.status = next.status, .data = next.data, .actual = next.actual});
    });
}

void FaultyUsbLink::endHeld(UsbStatus status) {
    for (auto& [endpoint, waiting] : held_) {
        while (!waiting.empty()) {
            const Held next = std::move(waiting.front());
            waiting.pop_front();
            next.done({.status = status});
        }
    }
    copies_.clear();
    while (!refused_.empty()) {
        const UsbCallback done = std::move(refused_.begin()->second.second);
        refused_.erase(refused_.begin());
        done({.status = status});
    }
}

void FaultyUsbLink::cancel(UsbTransferId id) {
    const auto refused = refused_.find(id);
    if (refused != refused_.end()) {
        auto [endpoint, done] = std::move(refused->second);
        refused_.erase(refused);
        tellLater(endpoint, Duration::zero(), {std::move(done), UsbStatus::Cancelled, {}, 0});
        return;
    }
    const auto found = innerIds_.find(id);
    if (found != innerIds_.end()) inner_->cancel(found->second);
}

void FaultyUsbLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

}  // namespace kickstand::testing
