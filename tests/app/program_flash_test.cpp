// Uploads to simulated robots.

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

/// A file of this content, in a folder of its own.
class TemporaryFile {
  public:
    TemporaryFile(const char* name, const QByteArray& content)
        : path_(folder_.filePath(QString::fromLatin1(name))) {
        QFile file(path_);
        written_ = file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
    }
    std::string path() const {
        EXPECT_TRUE(written_);
        return path_.toStdString();
    }

  private:
    QTemporaryDir folder_;
    QString path_;
    bool written_ = false;
};

QByteArray someBytes() {
    QByteArray bytes;
    for (int i = 0; i < 700; ++i)
        bytes.append(static_cast<char>(i * 7));
    return bytes;
}

TEST(ProgramFlash, ADryRunNeedsNoRobotAndShowsTheSignature) {
    const TemporaryFile file("main.bin", someBytes());
    const Ended ended =
        run({"--json", "thunderbots", "flash", "--robot", "3", "--target", "pic", "--dry-run", file.path()});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.object()[QStringLiteral("target")].toString(), QStringLiteral("microcontroller"));
    EXPECT_EQ(ended.object()[QStringLiteral("pages")].toInt(), 3);
    EXPECT_TRUE(ended.object()[QStringLiteral("signature")].isDouble());
}

TEST(ProgramFlash, RefusesFilesThatAreNone) {
    const TemporaryFile broken("broken.hex", ":00000001FE\n");
    const Ended ended = run({"thunderbots", "flash", "--robot", "3", "--dry-run", broken.path()});
    EXPECT_EQ(ended.exitCode, 2);
    EXPECT_NE(ended.err.find("broken.hex"), std::string::npos) << ended.err;
    EXPECT_EQ(run({"thunderbots", "flash", "--robot", "3", "--dry-run", "does-not-exist.bit"}).exitCode, 2);
    const TemporaryFile good("fpga.bin", someBytes());
    EXPECT_EQ(run({"thunderbots", "flash", "--robot", "3", "--target", "toaster", good.path()}).exitCode, 2);
    EXPECT_EQ(run({"thunderbots", "flash", "--robot", "3", "--dry-run", good.path(), good.path()}).exitCode,
              2)
        << "both for the same target";
}

TEST(ProgramFlash, ChangesNothingWithoutYes) {
    const TemporaryFile file("fpga.bin", someBytes());
    const Ended ended =
        runSimulated({"thunderbots", "flash", "--robot", "3", "--target", "fpga", file.path()});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_NE(ended.err.find("--yes"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("Robot 3 has microcontroller"), std::string::npos) << ended.out;
    EXPECT_EQ(ended.out.find("erasing"), std::string::npos) << ended.out;
}

TEST(ProgramFlash, UploadsVerifiesAndWritesItsLog) {
    const QTemporaryDir folder;
    const TemporaryFile file("fpga.bin", someBytes());
    const std::string log = folder.filePath(QStringLiteral("log.txt")).toStdString();
    const Ended ended = runSimulated({"--json", "thunderbots", "flash", "--robot", "2,3", "--target", "fpga",
                                      "--yes", "--force", "--log", log, file.path()});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("\"stage\":\"erasing\""), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("\"left\":\"complete\""), std::string::npos) << ended.out;
    QFile written(QString::fromStdString(log));
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const QByteArray lines = written.readAll();
    EXPECT_TRUE(lines.contains("Robot 2") && lines.contains("Robot 3") && lines.contains("verified"))
        << lines.constData();
}

TEST(ProgramFlash, VerifySaysThatItIsSomethingElse) {
    const TemporaryFile file("fpga.bin", someBytes());
    const Ended ended =
        runSimulated({"thunderbots", "verify", "--robot", "1", "--target", "fpga", file.path()});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_NE(ended.err.find("something else"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace kickstand::test
