// The program itself, from outside.

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>

#include <gtest/gtest.h>

namespace kickstand::test {
namespace {

constexpr int kWatchdog_ms = 600'000;

class ProgramTest : public testing::Test {
  protected:
    ProgramTest() {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            environment.remove(QLatin1String(name));
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.path());
        environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), folder.path());
        program.setProcessEnvironment(environment);
        program.setProgram(QStringLiteral(KICKSTAND_PROGRAM));
    }
    ~ProgramTest() override {
        if (program.state() == QProcess::NotRunning) return;
        program.kill();
        program.waitForFinished();
    }

    void offscreen() {
        QProcessEnvironment environment = program.processEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        program.setProcessEnvironment(environment);
    }
    int run(const QStringList& arguments) {
        program.setArguments(arguments);
        program.start();
        if (!program.waitForFinished(kWatchdog_ms) || program.exitStatus() != QProcess::NormalExit) return -1;
        return program.exitCode();
    }

    QTemporaryDir folder;
    QProcess program;
};

TEST_F(ProgramTest, HelpAndVersionNeedNoDisplay) {
    EXPECT_EQ(run({QStringLiteral("--help")}), 0);
    EXPECT_TRUE(program.readAllStandardOutput().contains("--tour"));
    EXPECT_EQ(run({QStringLiteral("--version")}), 0);
}

TEST_F(ProgramTest, ASecondStartShowsTheFirstWindowAndSaysSo) {
    offscreen();
    QProcess first;
    first.setProcessEnvironment(program.processEnvironment());
    first.start(QStringLiteral(KICKSTAND_PROGRAM),
                {QStringLiteral("--link"), QStringLiteral("sim:thunderbots")});
    const QString place = folder.filePath(QStringLiteral("kickstand-window"));
    QElapsedTimer watchdog;
    watchdog.start();
    // It has no other sign of having begun: its end would be one of failure.
    while (!QFile::exists(place) && watchdog.elapsed() < kWatchdog_ms && !first.waitForFinished(20)) {
    }
    ASSERT_TRUE(QFile::exists(place)) << first.readAllStandardError().toStdString();
    EXPECT_EQ(run({}), 0);
    EXPECT_TRUE(program.readAllStandardError().contains("open already"));
    EXPECT_EQ(run({QStringLiteral("--link"), QStringLiteral("sim:thunderbots")}), 1)
        << "the link was not connected to";
    EXPECT_TRUE(program.readAllStandardError().contains("--new-instance"));
    EXPECT_EQ(first.state(), QProcess::Running);
    first.terminate();
    EXPECT_TRUE(first.waitForFinished(kWatchdog_ms));
    EXPECT_EQ(first.exitCode(), 0);
}

TEST_F(ProgramTest, WithoutADisplayItSaysSoInOneLine) {
    EXPECT_EQ(run({}), 1);
    const QByteArray words = program.readAllStandardError();
    EXPECT_TRUE(words.contains("display"));
    EXPECT_EQ(words.count('\n'), 1);
}

TEST_F(ProgramTest, NonsenseIsRefusedInOneLineWithCodeTwo) {
    offscreen();
    const QList<QStringList> nonsense = {
        {QStringLiteral("--bogus")},
        {QStringLiteral("extra")},
        {QStringLiteral("--link")},
        {QStringLiteral("--link"), QStringLiteral("nonsense")},
        {QStringLiteral("--link"), QStringLiteral("sim:thunderbots?robots=99")},
        {QStringLiteral("--theme"), QStringLiteral("pink")},
        {QStringLiteral("--tour"), folder.path(), QStringLiteral("--link"), QStringLiteral("usb:")},
    };
    for (const QStringList& arguments : nonsense) {
        EXPECT_EQ(run(arguments), 2) << arguments.join(u' ').toStdString();
        EXPECT_EQ(program.readAllStandardError().count('\n'), 1) << arguments.join(u' ').toStdString();
    }
}

/// Whether most of a picture is dark: a single place may be in the middle of a letter.
bool isDark(const QImage& picture) {
    const QImage small = picture.scaled(64, 40).convertToFormat(QImage::Format_RGB32);
    int dark = 0;
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x)
            dark += small.pixelColor(x, y).lightness() < 128 ? 1 : 0;
    }
    return dark > small.width() * small.height() / 2;
}

TEST_F(ProgramTest, TheTourDrawsEveryStateInBothThemesWithoutADisplay) {
    const QString pictures = folder.filePath(QStringLiteral("tour"));
    ASSERT_EQ(run({QStringLiteral("--tour"), pictures}), 0) << program.readAllStandardError().toStdString();
    const QStringList files = QDir(pictures).entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Name);
    EXPECT_GE(files.size(), 24);
    EXPECT_EQ(files.filter(QStringLiteral("-light")).size(), files.filter(QStringLiteral("-dark")).size());
    for (const QString& file : files) {
        const QImage picture(QDir(pictures).filePath(file));
        ASSERT_FALSE(picture.isNull()) << file.toStdString();
        EXPECT_EQ(isDark(picture), file.contains(QStringLiteral("-dark"))) << file.toStdString();
    }
}

TEST_F(ProgramTest, AFolderThatCannotBeWrittenEndsTheTourWithOneLine) {
    QFile file(folder.filePath(QStringLiteral("file")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    EXPECT_EQ(run({QStringLiteral("--tour"), file.fileName() + QStringLiteral("/below")}), 1);
    EXPECT_TRUE(program.readAllStandardError().contains("cannot write"));
}

TEST_F(ProgramTest, ASignalEndsItWithCodeZero) {
    offscreen();
    for (const int signal : {SIGTERM, SIGINT}) {
        program.setArguments(
            {QStringLiteral("--announce"), QStringLiteral("--link"), QStringLiteral("sim:thunderbots")});
        program.start();
        ASSERT_TRUE(program.waitForReadyRead(kWatchdog_ms));
        ASSERT_EQ(kill(static_cast<pid_t>(program.processId()), signal), 0);
        ASSERT_TRUE(program.waitForFinished(kWatchdog_ms));
        EXPECT_EQ(program.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(program.exitCode(), 0);
    }
}

}  // namespace
}  // namespace kickstand::test
