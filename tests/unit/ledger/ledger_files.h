#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/ledger/parameter_record.h"

namespace kickstand::testing {

/// A folder of its own for each test, gone with it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  (std::string("kickstand-") + test->test_suite_name() + "-" + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~TemporaryFolder() {
        std::error_code error;
        std::filesystem::remove_all(folder_, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    /// A copy of a file of tests/data/ledger.
    std::string copyOf(const std::string& name) const {
        std::filesystem::copy_file(std::filesystem::path(KICKSTAND_LEDGER_DATA) / name, folder_ / name);
        return path(name);
    }

  private:
    std::filesystem::path folder_;
};

inline ParameterRecord recordOf(int robot, std::uint8_t duty = 120) {
    ParameterRecord record;
    record.time = std::chrono::system_clock::time_point(std::chrono::milliseconds(1'308'917'043'123));
    record.source = "usb:";
    record.robot = robot;
    record.block = {0, 14, 15, static_cast<std::uint8_t>(robot), duty, 0};
    return record;
}

}  // namespace kickstand::testing
