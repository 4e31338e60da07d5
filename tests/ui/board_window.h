#pragma once

#include <QAbstractButton>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/engine/engine.h"
#include "core/link/byte_tap.h"
#include "core/smartdevice/wire/frame.h"
#include "ui/shell/bench.h"
#include "ui/shell/main_window.h"
#include "ui/shell/theme.h"
#include "ui/smartdevice/device_list.h"
#include "ui/smartdevice/smartdevice_view.h"

namespace kickstand::test {

/// What the host has written to any board but pings, heartbeats and what it asks for updates with, as hex of
/// the message.
class BoardWrites final : public ByteTapObserver {
  public:
    void observe(const ByteTapRecord& record) override;
    std::vector<std::string> messages() const;
    std::string last() const;
    void clear();

  private:
    mutable std::mutex mutex_;
    smartdevice::wire::Decoder decoder_{smartdevice::wire::Dialect::Current};
    std::vector<std::string> messages_;
};

/// The whole window on simulated boards, each of whose lines is watched.
class BoardWindow : public testing::Test {
  protected:
    /// A board that the test is about comes first: it is board 0.
    void connectTo(const char* devices);
    /// The same, and no port can be opened for this reason.
    void connectInVain(Errc obstacle);
    void TearDown() override;

    static bool waitFor(const std::function<bool()>& condition);
    const smartdevice::Snapshot* state() { return ui::boardsOf(bench->session()); }
    const smartdevice::DeviceState& device(int number) {
        return state()->devices.at(static_cast<std::size_t>(number));
    }
    template <class Widget>
    Widget* find(const QString& name) {
        auto* widget = window->findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name.toStdString();
        return widget;
    }
    void click(const QString& name);
    QString text(const QString& label);
    /// Chooses a board in the list and waits until its parameters are shown.
    void choose(const QString& kind);
    QWidget* editor(int parameter) { return find<QWidget>(QStringLiteral("editor%1").arg(parameter)); }
    /// Types into a parameter's editor, and Enter.
    void type(int parameter, const QString& text);
    QString verdict(int parameter);
    bool waitForVerdict(int parameter, const char* words) {
        return waitFor([&] { return verdict(parameter) == QLatin1String(words); });
    }
    bool waitForWrite(const std::string& message) {
        return waitFor([&] { return writes.last() == message; });
    }
    const ui::DeviceLine& line(int row) {
        return find<ui::DeviceList>(QStringLiteral("boards"))->lines().at(static_cast<std::size_t>(row));
    }
    void simulate(const char* action, int unit, double value) {
        bench->submit(SimPerform{action, unit, value});
    }

    BoardWrites writes;
    std::unique_ptr<ui::EngineClient> client;
    std::unique_ptr<ui::Bench> bench;
    std::unique_ptr<ui::MainWindow> window;
    QSize size{1280, 800};  ///< The window's; before one is opened.
    QTemporaryDir folder;
    std::unique_ptr<QSettings> settings =
        std::make_unique<QSettings>(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);

  private:
    void open(std::optional<Errc> obstacle);

    std::unique_ptr<ui::Theme> theme_ = std::make_unique<ui::Theme>(*settings);
    ui::SystemRegistry systems_;
    std::unique_ptr<Engine> engine_;
};

}  // namespace kickstand::test
