#pragma once

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/contract/byte_rig.h"

namespace kickstand::testing {

/// The suite that every ByteLink passes: instantiate it with the factory of a rig.
class ByteLinkContract : public ::testing::TestWithParam<ByteRigFactory> {
  protected:
    using Bytes = std::vector<std::uint8_t>;

    void SetUp() override;
    void TearDown() override;

    /// Makes the link, anew where there is one.
    void makeLink();
    /// Opens and waits for however it ends.
    Result<ByteLinkInfo> tryOpen();
    /// Opens and waits; a failure fails the test. Waits for the device to know, too.
    ByteLinkInfo open();
    void close();
    void destroy();
    Result<void> write(const Bytes& bytes);
    Result<void> setBaud(Baud baud);
    void plug(bool in);
    bool deviceGets(const Bytes& bytes);
    bool hostGets(const Bytes& bytes);
    bool waitForPresence(std::size_t changes);

    std::unique_ptr<ByteRig> rig_;
    std::unique_ptr<ByteLink> link_;
    // On the links' thread only.
    Bytes received_;
    std::vector<bool> presence_;
};

}  // namespace kickstand::testing
