#include "core/link/tapped_byte_link.h"

#include <algorithm>
#include <utility>

namespace kickstand {

TappedByteLink::TappedByteLink(std::unique_ptr<ByteLink> inner, Scheduler& scheduler)
    : scheduler_(scheduler), inner_(std::move(inner)) {
    inner_->setReceiver([this](ByteView bytes) {
        observe({.kind = ByteTapRecord::Kind::Received, .data = bytes});
        // A copy, because the receiver may destroy this link.
        if (const auto receiver = receiver_) receiver(bytes);
    });
    inner_->setPresenceListener([this](bool present) {
        if (!present) {
            open_ = false;
            observe({.kind = ByteTapRecord::Kind::Lost});
        }
        if (const auto listener = presence_) listener(present);
    });
}

void TappedByteLink::addObserver(ByteTapObserver* observer) {
    observers_.push_back(observer);
}

void TappedByteLink::removeObserver(ByteTapObserver* observer) {
    // While observers are being told, the place stays, so that none is skipped.
    std::replace(observers_.begin(), observers_.end(), observer, static_cast<ByteTapObserver*>(nullptr));
    if (!observing_) std::erase(observers_, nullptr);
}

void TappedByteLink::open(std::function<void(Result<ByteLinkInfo>)> done) {
    inner_->open([this, done = std::move(done)](Result<ByteLinkInfo> opened) {
        if (opened) {
            open_ = true;
            observe({.kind = ByteTapRecord::Kind::Opened});
        }
        done(std::move(opened));
    });
}

void TappedByteLink::close(std::function<void()> done) {
    inner_->close([this, done = std::move(done)] {
        if (std::exchange(open_, false)) observe({.kind = ByteTapRecord::Kind::Closed});
        if (done) done();
    });
}

Result<void> TappedByteLink::write(ByteView bytes) {
    auto written = inner_->write(bytes);
    if (written) observe({.kind = ByteTapRecord::Kind::Sent, .data = bytes});
    return written;
}

void TappedByteLink::setBaud(Baud baud, std::function<void(Result<void>)> done) {
    inner_->setBaud(baud, std::move(done));
}

void TappedByteLink::setReceiver(std::function<void(ByteView)> receiver) {
    receiver_ = std::move(receiver);
}

void TappedByteLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

void TappedByteLink::observe(ByteTapRecord record) {
    record.time = scheduler_.now();
    observing_ = true;
    // By number, because an observer may be added meanwhile.
    for (std::size_t i = 0; i < observers_.size(); ++i) {
        if (observers_[i] != nullptr) observers_[i]->observe(record);
    }
    observing_ = false;
    std::erase(observers_, nullptr);
}

}  // namespace kickstand
