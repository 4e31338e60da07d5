#include "tests/support/serial/fake_byte_device.h"

namespace kickstand::testing {

void FakeByteDevice::lineOpened(Baud baud) {
    if (!attached_ || isOpen()) ++misuses_;
    ++opened_;
    baud_ = baud;
}

void FakeByteDevice::lineClosed() {
    if (!attached_ || !isOpen()) ++misuses_;
    ++closed_;
}

void FakeByteDevice::lineBaudChanged(Baud baud) {
    if (!attached_ || !isOpen()) ++misuses_;
    baud_ = baud;
}

void FakeByteDevice::hostSent(ByteView bytes) {
    if (!attached_ || !isOpen()) ++misuses_;
    received_.insert(received_.end(), bytes.begin(), bytes.end());
    if (echo_) send(bytes);
}

void FakeByteDevice::send(ByteView bytes) {
    if (listener_ != nullptr) listener_->deviceSent(bytes);
}

void FakeByteDevice::plug(bool in) {
    if (attached_ == in) return;
    attached_ = in;
    if (!in) closed_ = opened_;
    if (listener_ != nullptr) listener_->attachedChanged(in);
}

}  // namespace kickstand::testing
