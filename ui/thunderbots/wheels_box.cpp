#include "ui/thunderbots/wheels_box.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/thunderbots/body_box.h"
#include "ui/thunderbots/drive_control.h"
#include "ui/thunderbots/limit_row.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

enum RunSegment { kRun = 0, kBrake = 1, kNeither = -1 };
enum Page { kWheelsPage = 0, kBodyPage = 1 };

/// The whole box is to fit into the lowest window.
constexpr int kRowGap = 4;

}  // namespace

WheelsBox::WheelsBox(QWidget* parent)
    : QWidget(parent),
      mode_(new Segmented({tr("Wheels"), tr("Body")}, this)),
      run_(new Segmented({tr("Run"), tr("Brake")}, this)),
      release_(new QCheckBox(tr("Release to zero"), this)),
      body_(new BodyBox(this)),
      pages_(new QStackedWidget(this)),
      dribbler_(new QPushButton(tr("Dribbler"), this)),
      zero_(new QPushButton(tr("Zero   Z"), this)),
      limit_(new LimitRow(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kRowGap);
    column->addWidget(makeTop());
    pages_->addWidget(makeWheels());
    pages_->addWidget(body_);
    column->addWidget(pages_);
    column->addWidget(makeBottom());
    connect(body_, &BodyBox::asked, this, &WheelsBox::bodyAsked);
    setReleaseToZero(true);
    setBody(false);
}

QWidget* WheelsBox::makeWheels() {
    auto* page = new QWidget(pages_);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kRowGap);
    const std::array names = {tr("1 front L"), tr("2 back L"), tr("3 back R"), tr("4 front R")};
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
        wheels_[i] = new SetPointSlider(names[i], page);
        wheels_[i]->setObjectName(QStringLiteral("wheel%1").arg(i + 1));
        const int index = static_cast<int>(i);
        connect(wheels_[i], &SetPointSlider::asked, this,
                [this, index](int value, bool held) { emit wheelAsked(index, value, held); });
        column->addWidget(wheels_[i]);
    }
    return page;
}

QWidget* WheelsBox::makeTop() {
    auto* top = new QWidget(this);
    auto* row = new QHBoxLayout(top);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    row->addWidget(mode_);
    row->addWidget(run_);
    row->addStretch(1);
    mode_->button(kWheelsPage)->setObjectName(QStringLiteral("wheelMode"));
    mode_->button(kBodyPage)->setObjectName(QStringLiteral("bodyMode"));
    mode_->button(kWheelsPage)->setToolTip(tr("One set point for each wheel."));
    mode_->button(kBodyPage)->setToolTip(tr("How the body moves: forward, to the left, turning."));
    connect(mode_, &Segmented::asked, this, [this](int page) {
        setBody(page == kBodyPage);
        emit bodyChosen(page == kBodyPage);
    });
    run_->button(kRun)->setObjectName(QStringLiteral("run"));
    run_->button(kBrake)->setObjectName(QStringLiteral("brake"));
    run_->button(kRun)->setToolTip(tr("Motors follow the set points."));
    run_->button(kBrake)->setToolTip(tr("Motors are shorted: the wheels hold still."));
    release_->setObjectName(QStringLiteral("releaseToZero"));
    release_->setToolTip(tr("A slider springs back to zero when it is let go. Numbers that are typed stay."));
    connect(run_, &Segmented::asked, this, [this](int index) {
        if (index == kRun) emit runAsked();
        if (index == kBrake) emit brakeAsked();
    });
    connect(release_, &QCheckBox::toggled, this, [this](bool on) {
        setReleaseToZero(on);
        emit releaseToZeroChanged(on);
    });
    return top;
}

QWidget* WheelsBox::makeBottom() {
    auto* bottom = new QWidget(this);
    // The question that comes with a higher limit takes a line of its own where there is no room for it.
    auto* row = new FlowLayout(bottom);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    dribbler_->setObjectName(QStringLiteral("dribbler"));
    dribbler_->setCheckable(true);
    dribbler_->setAutoDefault(false);
    zero_->setObjectName(QStringLiteral("zero"));
    zero_->setAccessibleName(tr("Zero"));
    zero_->setToolTip(tr("All four set points to zero (Z)"));
    zero_->setAutoDefault(false);
    row->addWidget(dribbler_);
    row->addWidget(zero_);
    row->addWidget(limit_);
    connect(dribbler_, &QPushButton::clicked, this, &WheelsBox::dribblerAsked);
    connect(zero_, &QPushButton::clicked, this, &WheelsBox::zeroAsked);
    connect(limit_, &LimitRow::asked, this, &WheelsBox::limitAsked);
    return bottom;
}

void WheelsBox::showState(const DriveControl& control) {
    const ChoiceSummary& summary = control.summary();
    const bool follow = control.followsSnapshot();
    run_->setCurrent(summary.live == 0           ? kNeither
                     : summary.run == All::Every ? kRun
                     : summary.run == All::None  ? kBrake
                                                 : kNeither);
    dribbler_->setText(summary.dribbler == All::Some ? tr("Dribbler (some)") : tr("Dribbler"));
    if (follow) dribbler_->setChecked(summary.dribbler == All::Every);
    limit_->setLimit(control.limit());
    bool anyDiffers = false;
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
        SetPointSlider* wheel = wheels_[i];
        const int index = static_cast<int>(i);
        const bool differs = summary.live != 0 && control.differs(index);
        anyDiffers = anyDiffers || differs;
        wheel->setLimit(control.limit());
        wheel->showValue(control.wheels()[i]);
        wheel->setReached(summary.reached[i]);
        wheel->setMeaning(differs ? tr("differ") : wheelSpeedText(wheel->value(), unit_));
    }
    body_->showState(control.wheels(), control.limit(), follow, anyDiffers);
}

void WheelsBox::setUsable(bool usable) {
    for (QWidget* child : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        child->setEnabled(usable);
}

void WheelsBox::reset() {
    for (SetPointSlider* wheel : wheels_)
        wheel->reset();
    body_->reset();
}

void WheelsBox::setReleaseToZero(bool on) {
    release_->setChecked(on);
    for (SetPointSlider* wheel : wheels_)
        wheel->setReleaseToZero(on);
    body_->setReleaseToZero(on);
}

bool WheelsBox::isBody() const {
    return pages_->currentIndex() == kBodyPage;
}

void WheelsBox::setBody(bool on) {
    mode_->setCurrent(on ? kBodyPage : kWheelsPage);
    pages_->setCurrentIndex(on ? kBodyPage : kWheelsPage);
}

}  // namespace kickstand::ui
