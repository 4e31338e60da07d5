#include <QAbstractButton>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <memory>

#include "app/kickstand/tour_maker.h"
#include "ui/thunderbots/flash_panel.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

/// Others than the tour's own, whose capacitor is charged by now.
constexpr std::size_t kFlashed = 5;
constexpr std::size_t kFlashedToo = 7;
constexpr int kEmptyBattery = 8;
constexpr int kImageBytes = 6 * 1024;

/// Something that an FPGA would take for its bitstream: the sync word, and bytes that are not all alike.
QByteArray makeBitstream() {
    QByteArray bytes = QByteArray::fromHex("ffffffffffffffffaa995566");
    for (int at = static_cast<int>(bytes.size()); at < kImageBytes; ++at)
        bytes.append(static_cast<char>(at * 31 % 251));
    return bytes;
}

TourMaker::Done enabled(ui::MainWindow* window, const char* name) {
    return [window, name] {
        auto* button = window->findChild<QAbstractButton*>(QLatin1String(name));
        return button != nullptr && button->isEnabled() && button->isVisible();
    };
}

TourMaker::Done seen(ui::MainWindow* window, const char* label) {
    return [window, label] {
        auto* found = window->findChild<QLabel*>(QLatin1String(label));
        return found != nullptr && found->isVisible();
    };
}

/// Whether the robots' uploads both hold to something.
TourMaker::Done whenBoth(TourMaker& tour, const std::function<bool(const FlashProgress&)>& holds) {
    return tour.when([holds](const Snapshot& snapshot) {
        const auto& one = snapshot.flash[kFlashed];
        const auto& other = snapshot.flash[kFlashedToo];
        return one && other && holds(*one) && holds(*other);
    });
}

void addRobots(TourMaker& tour) {
    tour.add("firmware-panel", tour.goTo("firmware"));
    tour.add("firmware-choose", tour.press("robot5"));
    tour.add("firmware-another", tour.press("flashRobot7"));
    tour.add("firmware-empty-battery", tour.press("flashRobot8"));
    tour.show("firmware-robots", tour.simulate("battery", kEmptyBattery, 13.6),
              tour.when([](const Snapshot& s) { return s.robots[kEmptyBattery].readings.battery_V < 14; }));
    tour.add("firmware-leave-out", tour.press("flashRobot8"), enabled(tour.window(), "flashNext"));
}

void addFiles(TourMaker& tour) {
    // It lasts as long as the tour.
    auto folder = std::make_shared<QTemporaryDir>();
    tour.add("firmware-to-files", tour.press("flashNext"));
    tour.show(
        "firmware-files",
        [window = tour.window(), folder] {
            const QString path = folder->filePath(QStringLiteral("motor-control.bin"));
            QFile file(path);
            if (file.open(QIODevice::WriteOnly)) file.write(makeBitstream());
            file.close();
            window->findChild<ui::FlashPanel*>()->addFiles({path});
        },
        seen(tour.window(), "flashFile0"));
    tour.show("firmware-review", tour.press("flashNext"), enabled(tour.window(), "flashNext"));
}

void addUpload(TourMaker& tour) {
    tour.show("firmware-progress", tour.press("flashNext"), whenBoth(tour, [](const FlashProgress& progress) {
                  return progress.stage == FlashStage::Writing && progress.done_B > 0;
              }));
    tour.show(
        "firmware-paused",
        [window = tour.window()] {
            auto* stop = window->findChild<QAbstractButton*>(QStringLiteral("stop"));
            stop->setDown(true);
            emit stop->pressed();
            stop->setDown(false);
        },
        whenBoth(tour, [](const FlashProgress& progress) { return progress.paused; }));
    tour.add("firmware-rearm", tour.press("rearm"), enabled(tour.window(), "flashResume"));
    tour.show("firmware-result", tour.press("flashResume"), seen(tour.window(), "flashSentence5"));
    tour.add("firmware-again", tour.press("flashNext"));
}

}  // namespace

void addFirmwareSteps(TourMaker& tour) {
    addRobots(tour);
    addFiles(tour);
    addUpload(tour);
    tour.add("firmware-choose-first", tour.press("robot3"));
    tour.add("from-firmware", tour.goTo("drive"));
}

}  // namespace kickstand::app
