#include "app/kickstand/tour_maker.h"

#include <utility>

namespace kickstand::app {

using thunderbots::RobotState;
using thunderbots::Snapshot;

void TourMaker::add(const char* name, const Act& act, const Done& done) {
    steps_.push_back({QString::fromLatin1(name), act, done, {}});
}

void TourMaker::show(const char* name, const Act& act, const Done& done) {
    steps_.push_back({QString::fromLatin1(name), act, done, [window = window_] { return window->grab(); }});
}

void TourMaker::showOver(const char* name, const Act& act, const Done& done,
                         const std::function<QWidget*()>& over) {
    steps_.push_back({QString::fromLatin1(name), act, done, [window = window_, over] {
                          QPixmap picture = window->grab();
                          if (QWidget* top = over()) {
                              QPainter painter(&picture);
                              painter.drawPixmap(top->mapToGlobal(QPoint()) - window->mapToGlobal(QPoint()),
                                                 top->grab());
                          }
                          return picture;
                      }});
}

void TourMaker::showWindow(const char* name, const Act& act, const Done& done,
                           const std::function<QWidget*()>& picture) {
    steps_.push_back({QString::fromLatin1(name), act, done, [picture] { return picture()->grab(); }});
}

TourMaker::Act TourMaker::press(const char* name) const {
    return [window = window_, name] {
        if (auto* button = window->findChild<QAbstractButton*>(QLatin1String(name))) button->click();
    };
}

TourMaker::Act TourMaker::goTo(const char* place) const {
    return [bench = bench_, place] { bench->goTo(QString::fromLatin1(place)); };
}

TourMaker::Act TourMaker::simulate(const char* action, int unit, double value) const {
    return [bench = bench_, action, unit, value] { bench->submit(SimPerform{action, unit, value}); };
}

TourMaker::Done TourMaker::when(const std::function<bool(const Snapshot&)>& holds) const {
    return [bench = bench_, holds] {
        const Snapshot* snapshot = ui::snapshotOf(bench->session());
        return snapshot != nullptr && holds(*snapshot);
    };
}

TourMaker::Done TourMaker::whenRobot(const std::function<bool(const RobotState&)>& holds) const {
    return when([holds](const Snapshot& snapshot) { return holds(snapshot.robots[kRobot]); });
}

}  // namespace kickstand::app
