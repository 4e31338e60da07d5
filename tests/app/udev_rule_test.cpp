#include "app/composition/udev_rule.h"

#include <QStringList>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/engine/describe.h"

namespace kickstand {
namespace {

namespace fs = std::filesystem;

constexpr std::uint16_t kVendor = 0x04D8;
constexpr std::uint16_t kDongle = 0x7839;
constexpr std::uint16_t kCable = 0x783A;

class UdevRule : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "kickstand-udev-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        root_ = name;
    }
    void TearDown() override { fs::remove_all(root_); }

    void write(const fs::path& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }

    fs::path root_;
};

TEST_F(UdevRule, NoneOnAMachineWithoutUdev) {
    EXPECT_FALSE(findUdevRule(kVendor, kDongle, root_));
}

TEST_F(UdevRule, TheOneThatComesWithTheProgramLetsBothProductsIn) {
    std::ostringstream rule;
    rule << std::ifstream(KICKSTAND_UDEV_RULE).rdbuf();
    write("etc/udev/rules.d/60-kickstand.rules", rule.str());
    EXPECT_EQ(findUdevRule(kVendor, kDongle, root_), "/etc/udev/rules.d/60-kickstand.rules");
    EXPECT_EQ(findUdevRule(kVendor, kCable, root_), "/etc/udev/rules.d/60-kickstand.rules");
    EXPECT_FALSE(findUdevRule(kVendor, 0x1234, root_));
}

TEST_F(UdevRule, OneOfAPackageCountsToo) {
    write("lib/udev/rules.d/60-robots.rules",
          "ATTR{idVendor}==\"04d8\", ATTR{idProduct}==\"7839\", MODE=\"0666\"\n");
    EXPECT_EQ(findUdevRule(kVendor, kDongle, root_), "/lib/udev/rules.d/60-robots.rules");
}

TEST_F(UdevRule, TheOneThatTheProgramItselfRecommendsIsRecognised) {
    const QString command = describe(Error{.code = Errc::PermissionDenied}).remedyCommand;
    const QStringList parts = command.split(QLatin1Char('\''));
    ASSERT_GE(parts.size(), 3) << command.toStdString();
    write("etc/udev/rules.d/60-kickstand.rules", parts[1].toStdString() + "\n");
    EXPECT_TRUE(findUdevRule(kVendor, kDongle, root_));
    EXPECT_TRUE(findUdevRule(kVendor, kCable, root_));
    EXPECT_FALSE(findUdevRule(kVendor, 0x7840, root_));
}

TEST_F(UdevRule, AFileHidesOthersOfItsName) {
    write("lib/udev/rules.d/60-kickstand.rules",
          "ATTR{idVendor}==\"04d8\", ATTR{idProduct}==\"7839\", MODE=\"0666\"\n");
    ASSERT_TRUE(findUdevRule(kVendor, kDongle, root_));
    write("run/udev/rules.d/60-kickstand.rules", "");
    EXPECT_FALSE(findUdevRule(kVendor, kDongle, root_));
}

TEST_F(UdevRule, ACommentOrAnotherEndingLetsNobodyIn) {
    const std::string line = "ATTR{idVendor}==\"04d8\", ATTR{idProduct}==\"7839\", TAG+=\"uaccess\"\n";
    write("etc/udev/rules.d/60-a.rules", "#" + line);
    write("etc/udev/rules.d/60-b.rules.off", line);
    write("etc/udev/rules.d/60-c.rules",
          "ATTR{idVendor}==\"04d8\", ATTR{idProduct}==\"7839\", SYMLINK+=\"d\"\n");
    EXPECT_FALSE(findUdevRule(kVendor, kDongle, root_));
}

}  // namespace
}  // namespace kickstand
