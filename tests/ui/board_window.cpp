#include "tests/ui/board_window.h"

#include <QApplication>
#include <QLabel>
#include <algorithm>

#include "core/base/hex.h"
#include "core/link/tapped_byte_link.h"
#include "core/smartdevice/sim/simulated_ports.h"
#include "ui/shell/workbench.h"
#include "ui/smartdevice/device_list.h"

namespace kickstand::test {

namespace {

namespace wire = smartdevice::wire;

constexpr int kWatchdog_ms = 20'000;

class WatchedPorts final : public BytePorts {
  public:
    WatchedPorts(std::unique_ptr<BytePorts> inner, Scheduler& scheduler, BoardWrites& writes)
        : inner_(std::move(inner)), scheduler_(scheduler), writes_(writes) {}

    void watch(std::function<void(const std::vector<BytePort>&)> changed) override {
        inner_->watch(std::move(changed));
    }
    std::unique_ptr<ByteLink> makeLink(const std::string& name, Baud baud) override {
        auto tapped = std::make_unique<TappedByteLink>(inner_->makeLink(name, baud), scheduler_);
        tapped->addObserver(&writes_);
        return tapped;
    }

  private:
    std::unique_ptr<BytePorts> inner_;
    Scheduler& scheduler_;
    BoardWrites& writes_;
};

class BoardLinks final : public LinkProvider {
  public:
    explicit BoardLinks(BoardWrites& writes) : writes_(writes) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::Unsupported, toString(uri));
    }
    Result<ProvidedBytePorts> makeBytePorts(const LinkUri& uri, Scheduler& scheduler) override {
        const auto options = smartdevice::sim::parseSimOptions(uri);
        if (!options) return fail(options.error());
        const auto sim = std::make_shared<smartdevice::sim::SmartDeviceSim>(scheduler, *options);
        ProvidedBytePorts provided;
        provided.ports = std::make_unique<WatchedPorts>(smartdevice::sim::makeSimulatedPorts(scheduler, *sim),
                                                        scheduler, writes_);
        provided.sim = sim.get();
        provided.keepAlive = sim;
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([found = std::move(found)] { found({}); });
    }

  private:
    BoardWrites& writes_;
};

bool isAsked(const wire::Message& message) {
    return std::holds_alternative<wire::DeviceWrite>(message) ||
           std::holds_alternative<wire::DeviceDisable>(message);
}

}  // namespace

void BoardWrites::observe(const ByteTapRecord& record) {
    if (record.kind != ByteTapRecord::Kind::Sent) return;
    const std::lock_guard lock(mutex_);
    // Whole frames are handed over at once, whichever line they are for.
    decoder_.feed(record.data, [this](const wire::Message& message) {
        if (isAsked(message))
            messages_.push_back(toHex(wire::encodeMessage(wire::Dialect::Current, message).view()));
    });
}

std::vector<std::string> BoardWrites::messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

std::string BoardWrites::last() const {
    const std::lock_guard lock(mutex_);
    return messages_.empty() ? std::string() : messages_.back();
}

void BoardWrites::clear() {
    const std::lock_guard lock(mutex_);
    messages_.clear();
}

bool BoardWindow::waitFor(const std::function<bool()>& condition) {
    QElapsedTimer watch;
    watch.start();
    while (!condition()) {
        if (watch.elapsed() > kWatchdog_ms) return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

void BoardWindow::connectTo(const char* devices) {
    EngineOptions options;
    options.heartbeatLimit = std::chrono::seconds(10);
    engine_ = std::make_unique<Engine>(std::make_unique<BoardLinks>(writes), options);
    client = std::make_unique<ui::EngineClient>(*engine_);
    systems_.add(std::make_unique<ui::SmartdeviceView>());
    bench = std::make_unique<ui::Bench>(*client, systems_, *settings);
    window = std::make_unique<ui::MainWindow>(*bench, *theme_);
    window->resize(1280, 800);
    window->show();
    window->workbench().makePanels();
    const std::string uri = std::string("sim:smartdevice?boot_ms=10&devices=") + devices;
    bench->connectTo(*parseLinkUri(uri));
    const auto boards = static_cast<std::size_t>(std::count(uri.begin(), uri.end(), ',') + 1);
    ASSERT_TRUE(waitFor([this, boards] {
        return state() != nullptr && state()->devices.size() == boards &&
               std::ranges::all_of(state()->devices, [](const smartdevice::DeviceState& one) {
                   return !one.learning && (one.spec->readable() == 0 || one.samples > 0);
               });
    }));
    ASSERT_TRUE(waitFor([this] { return find<ui::DeviceList>(QStringLiteral("boards"))->count() > 0; }));
}

void BoardWindow::TearDown() {
    window.reset();
    if (engine_ != nullptr) engine_->shutdown();
}

void BoardWindow::click(const QString& name) {
    auto* button = find<QAbstractButton>(name);
    ASSERT_NE(button, nullptr);
    EXPECT_TRUE(button->isEnabled()) << name.toStdString();
    button->click();
}

QString BoardWindow::text(const QString& label) {
    auto* found = find<QLabel>(label);
    return found == nullptr ? QString() : found->text();
}

void BoardWindow::choose(const QString& kind) {
    auto* list = find<ui::DeviceList>(QStringLiteral("boards"));
    for (int row = 0; row < list->count(); ++row) {
        if (list->lines()[static_cast<std::size_t>(row)].kind == kind) list->setCurrentRow(row);
    }
    ASSERT_TRUE(
        waitFor([&] { return text(QStringLiteral("boardKind")).startsWith(kind + QStringLiteral(" ")); }));
}

}  // namespace kickstand::test
