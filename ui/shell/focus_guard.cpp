#include "ui/shell/focus_guard.h"

#include <QGuiApplication>
#include <QSettings>

#include "ui/shell/bench.h"

namespace kickstand::ui {

namespace {

constexpr const char* kSetting = "safety/stopWhenFocusIsLost";

}  // namespace

FocusGuard::FocusGuard(Bench& bench, QObject* parent)
    : QObject(parent), bench_(bench), on_(bench.settings().value(kSetting, true).toBool()) {
    connect(qApp, &QGuiApplication::applicationStateChanged, this, &FocusGuard::stateChanged);
}

void FocusGuard::setOn(bool on) {
    on_ = on;
    bench_.settings().setValue(kSetting, on);
}

void FocusGuard::stateChanged(Qt::ApplicationState state) {
    if (on_ && state != Qt::ApplicationActive && bench_.isMoving())
        bench_.client().stop(StopReason::FocusLost);
}

}  // namespace kickstand::ui
