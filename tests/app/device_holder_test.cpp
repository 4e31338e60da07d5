#include "app/composition/device_holder.h"

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace kickstand {
namespace {

namespace fs = std::filesystem;

/// A small /sys and /proc of our own.
class FindHolder : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "kickstand-holder-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        root_ = name;
        write("sys/bus/usb/devices/1-2.3/busnum", "1\n");
        write("sys/bus/usb/devices/1-2.3/devnum", "5\n");
    }
    void TearDown() override { fs::remove_all(root_); }

    void write(const fs::path& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }
    void process(const std::string& pid, const std::string& name, const std::string& open) const {
        write("proc/" + pid + "/comm", name + '\n');
        fs::create_directories(root_ / "proc" / pid / "fd");
        fs::create_symlink("/dev/null", root_ / "proc" / pid / "fd/0");
        fs::create_symlink(open, root_ / "proc" / pid / "fd/7");
    }

    fs::path root_;
};

TEST_F(FindHolder, FindsTheProgramThatHasTheDeviceOpen) {
    process("17", "editor", "/tmp/notes");
    process("4242", "soccer", "/dev/bus/usb/001/005");
    process("self", "mirror", "/dev/bus/usb/001/005");
    EXPECT_EQ(findHolder("1-2.3", root_), (DeviceHolder{4242, "soccer"}));
}

TEST_F(FindHolder, TellsDevicesApart) {
    process("4242", "soccer", "/dev/bus/usb/001/015");
    EXPECT_EQ(findHolder("1-2.3", root_), std::nullopt);
}

TEST_F(FindHolder, IsNotItsOwnFinding) {
    process(std::to_string(getpid()), "kickstandctl", "/dev/bus/usb/001/005");
    EXPECT_EQ(findHolder("1-2.3", root_), std::nullopt);
}

TEST_F(FindHolder, GivesUpOnWhatItCannotRead) {
    EXPECT_EQ(findHolder("9-9", root_), std::nullopt);
    EXPECT_EQ(findHolder("", root_), std::nullopt);
    EXPECT_EQ(findHolder("../../1-2.3", root_), std::nullopt);
    write("sys/bus/usb/devices/1-2.3/devnum", "five\n");
    EXPECT_EQ(findHolder("1-2.3", root_), std::nullopt);
    EXPECT_EQ(findHolder("1-2.3", root_ / "nowhere"), std::nullopt);
}

}  // namespace
}  // namespace kickstand
