#include "tests/ui/board_window.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <algorithm>

#include "core/base/hex.h"
#include "core/link/tapped_byte_link.h"
#include "core/smartdevice/sim/simulated_ports.h"
#include "ui/shell/workbench.h"
#include "ui/widgets/state_label.h"

namespace kickstand::test {

namespace {

namespace wire = smartdevice::wire;

constexpr int kWatchdog_ms = 20'000;

/// A link to a port that cannot be opened.
class ClosedLink final : public ByteLink {
  public:
    ClosedLink(Scheduler& scheduler, Errc code, std::string port) : scheduler_(scheduler) {
        error_.code = code;
        error_.port = std::move(port);
    }
    void open(std::function<void(Result<ByteLinkInfo>)> done) override {
        scheduler_.post([done = std::move(done), error = error_] { done(fail(error)); });
    }
    void close(std::function<void()> done) override {
        if (done) scheduler_.post(std::move(done));
    }
    Result<void> write(ByteView) override { return fail(Errc::NotConnected); }
    std::size_t waiting() const override { return 0; }
    void setBaud(Baud, std::function<void(Result<void>)>) override {}
    void setReceiver(std::function<void(ByteView)>) override {}
    void setPresenceListener(std::function<void(bool)>) override {}

  private:
    Scheduler& scheduler_;
    Error error_;
};

class WatchedPorts final : public BytePorts {
  public:
    WatchedPorts(std::unique_ptr<BytePorts> inner, Scheduler& scheduler, BoardWrites& writes,
                 std::optional<Errc> obstacle)
        : inner_(std::move(inner)), scheduler_(scheduler), writes_(writes), obstacle_(obstacle) {}

    void watch(std::function<void(const std::vector<BytePort>&)> changed) override {
        inner_->watch(std::move(changed));
    }
    std::unique_ptr<ByteLink> makeLink(const std::string& name, Baud baud) override {
        if (obstacle_) return std::make_unique<ClosedLink>(scheduler_, *obstacle_, name);
        auto tapped = std::make_unique<TappedByteLink>(inner_->makeLink(name, baud), scheduler_);
        tapped->addObserver(&writes_);
        return tapped;
    }

  private:
    std::unique_ptr<BytePorts> inner_;
    Scheduler& scheduler_;
    BoardWrites& writes_;
    const std::optional<Errc> obstacle_;
};

class BoardLinks final : public LinkProvider {
  public:
    BoardLinks(BoardWrites& writes, std::optional<Errc> obstacle) : writes_(writes), obstacle_(obstacle) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::Unsupported, toString(uri));
    }
    Result<ProvidedBytePorts> makeBytePorts(const LinkUri& uri, Scheduler& scheduler) override {
        const auto options = smartdevice::sim::parseSimOptions(uri);
        if (!options) return fail(options.error());
        const auto sim = std::make_shared<smartdevice::sim::SmartDeviceSim>(scheduler, *options);
        ProvidedBytePorts provided;
        provided.ports = std::make_unique<WatchedPorts>(smartdevice::sim::makeSimulatedPorts(scheduler, *sim),
                                                        scheduler, writes_, obstacle_);
        provided.sim = sim.get();
        provided.keepAlive = sim;
        return provided;
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([found = std::move(found)] { found({}); });
    }

  private:
    BoardWrites& writes_;
    const std::optional<Errc> obstacle_;
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

void BoardWindow::open(std::optional<Errc> obstacle) {
    EngineOptions options;
    options.heartbeatLimit = std::chrono::seconds(10);
    engine_ = std::make_unique<Engine>(std::make_unique<BoardLinks>(writes, obstacle), options);
    client = std::make_unique<ui::EngineClient>(*engine_);
    systems_.add(std::make_unique<ui::SmartdeviceView>());
    bench = std::make_unique<ui::Bench>(*client, systems_, *settings);
    window = std::make_unique<ui::MainWindow>(*bench, *theme_);
    window->resize(size);
    window->show();
    window->workbench().makePanels();
}

void BoardWindow::connectInVain(Errc obstacle) {
    open(obstacle);
    bench->connectTo(*parseLinkUri("sim:smartdevice?devices=TeamFlag"));
    ASSERT_TRUE(waitFor([this] { return find<ui::DeviceList>(QStringLiteral("boards"))->count() == 1; }));
}

void BoardWindow::connectTo(const char* devices) {
    open({});
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

void BoardWindow::type(int parameter, const QString& text) {
    auto* field = editor(parameter)->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

QString BoardWindow::verdict(int parameter) {
    return find<ui::StateLabel>(QStringLiteral("verdict%1").arg(parameter))->text();
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
