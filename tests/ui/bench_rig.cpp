#include "tests/ui/bench_rig.h"

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QSpinBox>
#include <QTest>
#include <chrono>

#include "ui/shell/workbench.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {

using namespace thunderbots;

namespace {

constexpr int kWatchdog_ms = 20'000;

/// On a machine that is busy with other tests a window may be late without being frozen.
EngineOptions patientEngine() {
    EngineOptions options;
    options.heartbeatLimit = std::chrono::seconds(10);
    return options;
}

}  // namespace

bool waitUntil(const std::function<bool()>& condition) {
    QElapsedTimer watch;
    watch.start();
    while (!condition()) {
        if (watch.elapsed() > kWatchdog_ms) return false;
        // The client's own timers bring events many times a second.
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

BenchRig::BenchRig()
    : settings_(std::make_unique<QSettings>(folder_.filePath(QStringLiteral("settings.ini")),
                                            QSettings::IniFormat)),
      theme_(std::make_unique<ui::Theme>(*settings_)),
      engine_(std::make_unique<Engine>(makeTestLinks(board_), patientEngine())),
      client_(std::make_unique<ui::EngineClient>(*engine_)) {
    systems_.add(std::make_unique<ui::ThunderbotsView>(ledger_));
    feed_ = std::make_unique<ui::LedgerFeed>(*client_, ledger_);
    bench_ = std::make_unique<ui::Bench>(*client_, systems_, *settings_);
    stopFilter_ = std::make_unique<ui::StopFilter>([this] { return bench_->isActive(); });
    QObject::connect(stopFilter_.get(), &ui::StopFilter::stopAsked, client_.get(),
                     [this] { client_->stop(StopReason::Person); });
    window_ = std::make_unique<ui::MainWindow>(*bench_, *theme_);
    window_->resize(1280, 800);
    window_->show();
    window_->workbench().makePanels();
    QApplication::setActiveWindow(window_.get());
}

BenchRig::~BenchRig() {
    window_.reset();
}

bool BenchRig::connectTo(const char* uri) {
    const Result<LinkUri> link = parseLinkUri(uri);
    if (!link) return false;
    window_->connector().connectTo(*link);
    const bool connected = waitForSnapshot([](const Snapshot& snapshot) {
        if (snapshot.link != LinkState::Running || snapshot.eStop != wire::EStop::Run) return false;
        int current = 0;
        for (const RobotState& robot : snapshot.robots) {
            if (robot.live && robot.freshness != Freshness::Current) return false;
            current += robot.live ? 1 : 0;
        }
        return current >= (snapshot.cable ? 1 : 6);
    });
    wire().clear();
    return connected;
}

bool BenchRig::waitForSnapshot(const std::function<bool(const Snapshot&)>& condition) {
    return waitUntil([this, &condition] {
        const Snapshot* now = snapshot();
        return now != nullptr && condition(*now);
    });
}

bool BenchRig::waitForBlock(int robot, const std::function<bool(const wire::DriveBlock&)>& condition) {
    return waitUntil([this, robot, &condition] {
        const auto block = wire().last(robot);
        return block && condition(*block);
    });
}

bool BenchRig::waitForAnyBlock(int robot, const std::function<bool(const wire::DriveBlock&)>& condition) {
    return waitUntil([this, robot, &condition] {
        const std::vector<wire::DriveBlock> blocks = wire().blocks(robot);
        return std::any_of(blocks.begin(), blocks.end(), condition);
    });
}

bool BenchRig::settle() {
    if (!waitUntil([this] { return !client_->hasPending(); })) return false;
    // What was answered is in the snapshot after this.
    const TimePoint asked = client_->now();
    client_->submit(0, Discover{});
    return waitUntil([this, asked] { return client_->snapshot().time > asked; });
}

bool BenchRig::rearm() {
    if (!settle()) return false;
    client_->rearm();
    return settle();
}

void BenchRig::simulate(const char* action, int unit, double value) {
    bench_->submit(SimPerform{action, unit, value});
}

void BenchRig::click(const QString& name) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(button->isEnabled()) << name.toStdString();
    ASSERT_TRUE(button->isVisible()) << name.toStdString();
    QTest::mouseClick(button, Qt::LeftButton);
}

void BenchRig::clickRobot(int robot, Qt::KeyboardModifiers modifiers) {
    QTest::mouseClick(find<QWidget>(QStringLiteral("robot%1").arg(robot)), Qt::LeftButton, modifiers);
}

void BenchRig::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QWidget* target = QApplication::focusWidget();
    QTest::keyClick(target == nullptr ? window_.get() : target, key, modifiers);
}

void BenchRig::typeWheel(int wheel, const QString& number) {
    auto* field = find<ui::SetPointSlider>(QStringLiteral("wheel%1").arg(wheel))->field();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, number);
    QTest::keyClick(field, Qt::Key_Return);
}

}  // namespace kickstand::test
