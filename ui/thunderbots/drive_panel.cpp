#include "ui/thunderbots/drive_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QResizeEvent>
#include <QScrollArea>
#include <QSettings>
#include <QShortcut>
#include <QVBoxLayout>
#include <chrono>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/drive_control.h"
#include "ui/thunderbots/drive_keys_box.h"
#include "ui/thunderbots/high_voltage_box.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/wheels_box.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/scrolled.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

using namespace std::chrono_literals;

constexpr const char* kReleaseSetting = "drive/releaseToZero";
constexpr const char* kBodySetting = "drive/body";
/// From here on the two boxes stand side by side.
constexpr int kWideEnough = 600;
constexpr int kVoltageWidth = 236;
constexpr int kBoxGap = 20;
constexpr int kLeastWidth = 540;

}  // namespace

DrivePanel::DrivePanel(Bench& bench, DriveControl& control, QWidget* parent)
    : Panel(bench, parent),
      control_(control),
      boxes_(new QBoxLayout(QBoxLayout::LeftToRight)),
      wheels_(new WheelsBox(this)),
      keys_(new DriveKeysBox(bench.settings(), this)),
      voltage_(new HighVoltageBox({}, this)),
      told_(new QLabel(this)),
      notice_(new QLabel(this)) {
    build();
    wheels_->setReleaseToZero(bench.settings().value(kReleaseSetting, true).toBool());
    wheels_->setBody(bench.settings().value(kBodySetting, false).toBool());
    connectWheels();
    connectVoltage();
    chooseUnit();
    connect(&bench, &Bench::unitsChanged, this, [this] {
        chooseUnit();
        refresh();
    });
    control_.attach(bench);
    connect(&control_, &DriveControl::changed, this, &DrivePanel::refresh);
    connect(&control_, &DriveControl::dropped, this, [this] {
        wheels_->reset();
        keys_->letGo();
        refusal_.clear();
        keyNotice_.clear();
    });
    // The age of a lost capacitor goes on while nothing else happens.
    connect(&ages_, &QTimer::timeout, this, &DrivePanel::refresh);
    ages_.start(1s);
    connect(new QShortcut(QKeySequence(Qt::Key_Z), this), &QShortcut::activated, &control_,
            &DriveControl::zero);
    refresh();
}

void DrivePanel::build() {
    told_->setObjectName(QStringLiteral("told"));
    told_->setFont(numberFont(metrics::kSmallTextSize + 1));
    told_->setForegroundRole(QPalette::PlaceholderText);
    notice_->setObjectName(QStringLiteral("notice"));
    notice_->setWordWrap(true);
    notice_->setMinimumHeight(20);
    boxes_->setSpacing(kBoxGap);
    boxes_->addWidget(wheels_, 1);
    boxes_->addWidget(voltage_);
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    // All of it fits into the smallest window.
    column->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, 4);
    column->setSpacing(4);
    column->addLayout(boxes_);
    column->addWidget(keys_);
    auto* bottom = new QHBoxLayout;
    bottom->setSpacing(metrics::kGap);
    bottom->addWidget(notice_, 1);
    bottom->addWidget(wheels_->releaseBox());
    column->addStretch(1);
    // A window that is too low for all of it scrolls.
    QScrollArea* area = scrolled(content, this);
    area->setMinimumWidth(kLeastWidth);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    whole->addWidget(area, 1);
    bottom->setContentsMargins(metrics::kPadding, 0, metrics::kPadding, 4);
    whole->addLayout(bottom);
}

void DrivePanel::chooseUnit() {
    wheels_->setUnit(static_cast<WheelUnit>(bench().unitOf(kWheelSpeed)));
}

QWidget* DrivePanel::headerTools() {
    return told_;
}

void DrivePanel::connectWheels() {
    connect(wheels_, &WheelsBox::wheelAsked, &control_, &DriveControl::setWheel);
    connect(wheels_, &WheelsBox::bodyAsked, this, [this](const BodyMotion& motion, bool held) {
        control_.setWheels(DriveInput::Panel, wheelsOf(motion, control_.limit()).wheels, held);
    });
    connect(wheels_, &WheelsBox::zeroAsked, &control_, &DriveControl::zero);
    connect(wheels_, &WheelsBox::runAsked, &control_, &DriveControl::run);
    connect(wheels_, &WheelsBox::brakeAsked, &control_, &DriveControl::brake);
    connect(wheels_, &WheelsBox::dribblerAsked, &control_, &DriveControl::setDribbler);
    connect(wheels_, &WheelsBox::limitAsked, &control_, &DriveControl::setLimit);
    connect(wheels_, &WheelsBox::releaseToZeroChanged, this,
            [this](bool on) { bench().settings().setValue(kReleaseSetting, on); });
    connect(wheels_, &WheelsBox::bodyChosen, this,
            [this](bool on) { bench().settings().setValue(kBodySetting, on); });
    connect(keys_, &DriveKeysBox::asked, this, &DrivePanel::keysAsked);
    connect(keys_, &DriveKeysBox::noticed, this, [this](const QString& words) {
        keyNotice_ = words;
        showNotice();
    });
}

void DrivePanel::connectVoltage() {
    connect(voltage_, &HighVoltageBox::armAsked, this, [this](bool on) {
        ask(ArmHighVoltage{control_.summary().live, on});
    });
    connect(voltage_, &HighVoltageBox::chargerAsked, this, [this](bool on) {
        ask(SetCharger{control_.summary().live, on});
    });
    connect(voltage_, &HighVoltageBox::dischargeAsked, this, [this](bool on) {
        for (int robot = 0; robot < kRobots; ++robot) {
            if (contains(control_.summary().live, robot)) ask(Discharge{robot, on});
        }
    });
}

void DrivePanel::keysAsked(const BodyMotion& part) {
    const BodyMotion most = fastestMotion(control_.limit());
    const BodyMotion motion{part.x_m_per_s * most.x_m_per_s, part.y_m_per_s * most.y_m_per_s,
                            part.turn_rad_per_s * most.turn_rad_per_s};
    keyNotice_.clear();
    const bool drives = control_.setWheels(DriveInput::Keys, wheelsOf(motion, control_.limit()).wheels, true);
    if (!drives) keyNotice_ = tr("Something else is held that drives. Let go of it first.");
    refresh();
}

void DrivePanel::refresh() {
    const ChoiceSummary& summary = control_.summary();
    wheels_->showState(control_);
    voltage_->showState(summary, bench().client().now(), waiting_ == 0 && control_.followsSnapshot());
    const QString& reason = control_.reasonNotToDrive();
    const bool usable = reason.isEmpty();
    wheels_->setUsable(usable);
    keys_->setUsable(usable);
    voltage_->setObstacle(reason);
    setNote(summary.chosen == 0 ? tr("no robot chosen") : robotsText(summary.chosen));
    showTold();
    showNotice();
}

void DrivePanel::showTold() {
    const ChoiceSummary& summary = control_.summary();
    QString text;
    if (summary.live == 0) {
        text = tr("told: \u2014");
    } else if (summary.toldDiffers) {
        text = tr("told: each something else");
    } else {
        text = tr("told: %1").arg(summary.told ? toldText(*summary.told) : QStringLiteral("\u2014"));
    }
    told_->setText(text);
}

void DrivePanel::showNotice() {
    const QString& reason = control_.reasonNotToDrive();
    QString words = control_.refusal();
    if (words.isEmpty()) words = refusal_;
    if (words.isEmpty()) words = keyNotice_;
    notice_->setForegroundRole(reason.isEmpty() && !words.isEmpty() ? QPalette::WindowText
                                                                    : QPalette::PlaceholderText);
    notice_->setText(reason.isEmpty() ? words : reason);
}

void DrivePanel::ask(const thunderbots::Command& command) {
    ++waiting_;
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        --waiting_;
        if (!result) refusal_ = describe(result.error()).line();
        refresh();
    });
}

void DrivePanel::closed() {
    if (bench().isActive()) bench().client().stop(StopReason::PanelClosed);
}

void DrivePanel::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    const bool wide = event->size().width() >= kWideEnough;
    boxes_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    // Its sentences wrap: the room is for the sliders.
    voltage_->setMinimumWidth(wide ? kVoltageWidth : 0);
    voltage_->setMaximumWidth(wide ? kVoltageWidth : QWIDGETSIZE_MAX);
}

}  // namespace kickstand::ui
