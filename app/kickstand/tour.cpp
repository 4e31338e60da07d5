#include "app/kickstand/tour.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPixmap>
#include <chrono>
#include <cstdio>

#include "app/kickstand/tour_steps.h"
#include "ui/shell/bench.h"
#include "ui/shell/main_window.h"
#include "ui/shell/theme.h"

namespace kickstand::app {

namespace {

using namespace std::chrono_literals;

/// Far longer than any step takes.
constexpr auto kStepLimit = 30s;

}  // namespace

Tour::Tour(ui::MainWindow& window, ui::Bench& bench, ui::Theme& theme, TourBus& bus, const QString& folder)
    : theme_(theme), folder_(folder), steps_(tourSteps(window, bench, bus)) {
    watchdog_.setSingleShot(true);
    connect(&watchdog_, &QTimer::timeout, this, [this] { fail(tr("did not come about in time")); });
    connect(&bench, &ui::Bench::changed, this, &Tour::check);
    connect(&bench.client(), &ui::EngineClient::stopChanged, this, &Tour::check);
}

void Tour::start() {
    if (!folder_.mkpath(QStringLiteral("."))) {
        fail(tr("cannot write to %1").arg(folder_.absolutePath()));
        return;
    }
    begin();
}

void Tour::begin() {
    // From the event loop: what the last step has set going is drawn first.
    QTimer::singleShot(0, this, [this] {
        if (over_) return;
        watchdog_.start(kStepLimit);
        steps_[current_].act();
        acted_ = true;
        check();
    });
}

void Tour::check() {
    if (over_ || !acted_) return;
    const TourStep& step = steps_[current_];
    if (!step.done()) return;
    acted_ = false;
    if (step.picture) {
        ++pictures_;
        takePicture(ui::ThemeChoice::Dark);
    } else {
        goOn();
    }
}

void Tour::goOn() {
    if (++current_ < steps_.size()) {
        begin();
        return;
    }
    over_ = true;
    watchdog_.stop();
    emit finished(0);
}

void Tour::takePicture(ui::ThemeChoice theme) {
    theme_.useNow(theme);
    // Widgets hear of their new palette from the event loop.
    QTimer::singleShot(0, this, [this, theme] {
        if (over_) return;
        // Words that have just changed get their room before they are drawn.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        const TourStep& step = steps_[current_];
        const bool dark = theme == ui::ThemeChoice::Dark;
        const QString file = QStringLiteral("%1-%2-%3.png")
                                 .arg(pictures_, 2, 10, QLatin1Char('0'))
                                 .arg(step.name, QLatin1String(dark ? "dark" : "light"));
        if (!step.picture().save(folder_.filePath(file))) {
            fail(tr("cannot write %1").arg(folder_.filePath(file)));
        } else if (dark) {
            takePicture(ui::ThemeChoice::Light);
        } else {
            goOn();
        }
    });
}

void Tour::fail(const QString& why) {
    if (over_) return;
    over_ = true;
    watchdog_.stop();
    const QString step = current_ < steps_.size() ? steps_[current_].name : QString();
    std::fprintf(stderr, "kickstand: the tour stopped at \"%s\": %s\n", qPrintable(step), qPrintable(why));
    emit finished(1);
}

}  // namespace kickstand::app
