#include <QComboBox>
#include <QLabel>
#include <QTimer>
#include <chrono>
#include <memory>

#include "app/kickstand/tour_maker.h"
#include "ui/gamepad/virtual_pad.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

/// The axes and buttons of a standard controller.
constexpr int kLeftStickUpDown = 1;
constexpr int kLeftShoulder = 9;
constexpr double kPushed = -0.6;

/// A gamepad in SDL's memory, and the hand that has it.
class Hand {
  public:
    explicit Hand(ui::MainWindow* window) : window_(window) {
        // No hand holds a stick quite still: one that is still for seconds counts as asleep.
        QObject::connect(&tremor_, &QTimer::timeout, &tremor_, [this] {
            off_ = -off_;
            pad_->move(kLeftStickUpDown, kPushed + off_);
        });
        tremor_.setInterval(kTremor);
    }

    /// Whether it is there and can be chosen. There is no gamepad before the panel has begun to look for one.
    bool plugIn() {
        if (pad_ == nullptr) pad_ = std::make_unique<ui::VirtualPad>(true);
        if (!pad_->works()) pad_.reset();
        if (pad_ == nullptr) return false;
        auto* pads = find<QComboBox>("pads");
        if (!pads->isEnabled()) return false;
        // The last to come is the last in the list, whatever else is plugged in.
        const int last = pads->count() - 1;
        if (pads->currentIndex() != last) emit pads->activated(last);
        return find<QAbstractButton>("padOn")->isEnabled();
    }
    void plugInAgain() {
        pad_ = std::make_unique<ui::VirtualPad>(true);
        push();
    }
    void unplug() {
        tremor_.stop();
        pad_.reset();
    }
    void push() {
        pad_->move(kLeftStickUpDown, kPushed);
        tremor_.start();
    }
    void letGo() {
        tremor_.stop();
        pad_->move(kLeftStickUpDown, 0);
    }
    void press(int button, bool down) { pad_->press(button, down); }

    bool says(const QString& words) const { return find<QLabel>("padState")->text().contains(words); }
    QString input(const char* name) const { return find<QAbstractButton>(name)->text(); }

  private:
    template <class Widget>
    Widget* find(const char* name) const {
        return window_->findChild<Widget*>(QLatin1String(name));
    }

    static constexpr std::chrono::milliseconds kTremor{300};

    ui::MainWindow* window_;
    std::unique_ptr<ui::VirtualPad> pad_;
    QTimer tremor_;
    double off_ = 0.01;
};

/// The dribbler gets another button, as a person gives it one.
void addMapping(TourMaker& tour, const std::shared_ptr<Hand>& hand) {
    constexpr const char* kDribbler = "padInput6";
    const QString before = QStringLiteral("press a button\u2026");
    tour.add("gamepad-choose", tour.press(kDribbler),
             [hand, before] { return hand->input(kDribbler) == before; });
    tour.add(
        "gamepad-press", [hand] { hand->press(kLeftShoulder, true); },
        [hand, before] { return hand->input(kDribbler) != before; });
    tour.show("gamepad-mapped", [hand] { hand->press(kLeftShoulder, false); });
}

void addLoss(TourMaker& tour, const std::shared_ptr<Hand>& hand) {
    const auto braked =
        tour.whenRobot([](const RobotState& robot) { return robot.told && !robot.told->run; });
    tour.show(
        "gamepad-lost", [hand] { hand->unplug(); },
        [hand, braked] { return hand->says(QStringLiteral("gone")) && braked(); });
    tour.show(
        "gamepad-back", [hand] { hand->plugInAgain(); },
        [hand] { return hand->says(QStringLiteral("Let go of both sticks")); });
    tour.add(
        "gamepad-neutral", [hand] { hand->letGo(); },
        [hand] { return hand->says(QStringLiteral("It drives")); });
}

}  // namespace

void addGamepadSteps(TourMaker& tour) {
    const auto hand = std::make_shared<Hand>(tour.window());
    tour.add("gamepad-panel", tour.goTo("gamepad"));
    tour.show("gamepad", [] {});
    tour.show(
        "gamepad-plugged-in", [] {}, [hand] { return hand->plugIn(); });
    addMapping(tour, hand);
    tour.add("gamepad-on", tour.press("padOn"), [hand] { return hand->says(QStringLiteral("It drives")); });
    tour.show(
        "gamepad-drives", [hand] { hand->push(); },
        tour.whenRobot([](const RobotState& robot) { return robot.told && robot.told->wheels[3] > 20; }));
    addLoss(tour, hand);
    tour.add("gamepad-standard", tour.press("padStandard"));
    tour.add("gamepad-off", tour.press("padOn"),
             [hand] { return hand->says(QStringLiteral("It does not drive")); });
    tour.add("gamepad-away", [hand] { hand->unplug(); });
    tour.add("gamepad-drive-panel", tour.goTo("drive"));
}

}  // namespace kickstand::app
