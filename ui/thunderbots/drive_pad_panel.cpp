#include "ui/thunderbots/drive_pad_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QShowEvent>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTimer>
#include <cmath>

#include "ui/gamepad/pad_picture.h"
#include "ui/thunderbots/drive_control.h"
#include "ui/thunderbots/drive_pad.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/scrolled.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

enum Mode { kBody = 0, kWheels = 1 };

constexpr int kColumnGap = 12;
constexpr int kNumberWidth = 56;
constexpr int kInputWidth = 112;
constexpr int kPictureSize = 96;
/// The sticks of one way of driving, or the buttons, one below the other.
constexpr int kMapRows = 4;
constexpr int kWidestDeadZone_percent = 50;

int percent(double part) {
    return static_cast<int>(std::lround(part * 100));
}

}  // namespace

DrivePadPanel::DrivePadPanel(Bench& bench, DriveControl& control, DrivePad* pad, QWidget* parent)
    : Panel(bench, parent), control_(control), pad_(pad) {
    pad_->setParent(this);
    setObjectName(QStringLiteral("padPanel"));
    picture_ = new PadPicture(this);
    picture_->setMinimumSize(kPictureSize, kPictureSize);
    auto* row = new QHBoxLayout;
    row->setSpacing(kColumnGap);
    row->addWidget(makeMap(), 1);
    row->addWidget(picture_);
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(metrics::kPadding, 10, metrics::kPadding, metrics::kGap);
    column->setSpacing(metrics::kGap);
    column->addWidget(makeTop());
    column->addLayout(row);
    column->addWidget(makeFeel());
    column->addStretch(1);
    // A window that is too small for all of it scrolls.
    QScrollArea* area = scrolled(content, this);
    area->setMinimumWidth(content->minimumSizeHint().width());
    // What an input is called may be longer.
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    whole->addWidget(area, 1);
    whole->addWidget(makeState());
    connect(pad_, &DrivePad::changed, this, &DrivePadPanel::refresh);
    connect(pad_, &DrivePad::moved, this, &DrivePadPanel::showPicture);
    connect(&control_, &DriveControl::changed, this, &DrivePadPanel::refresh);
    refresh();
}

QWidget* DrivePadPanel::makeState() {
    auto* box = new QWidget(this);
    sign_ = new StateLabel(box);
    sign_->setObjectName(QStringLiteral("padSign"));
    sign_->setState(Tone::Warning, {});
    state_ = new QLabel(box);
    state_->setObjectName(QStringLiteral("padState"));
    state_->setWordWrap(true);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(metrics::kPadding, 4, metrics::kPadding, metrics::kGap);
    row->setSpacing(0);
    row->addWidget(sign_, 0, Qt::AlignTop);
    row->addWidget(state_, 1);
    return box;
}

QWidget* DrivePadPanel::makeTop() {
    auto* top = new QWidget(this);
    pads_ = new QComboBox(top);
    pads_->setObjectName(QStringLiteral("pads"));
    pads_->setAccessibleName(tr("Gamepad"));
    pads_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    on_ = new QPushButton(tr("Drive with it"), top);
    on_->setObjectName(QStringLiteral("padOn"));
    on_->setCheckable(true);
    on_->setAutoDefault(false);
    on_->setToolTip(tr("Its STOP button counts in any case."));
    mode_ = new Segmented({tr("Body"), tr("Wheels")}, top);
    mode_->button(kBody)->setObjectName(QStringLiteral("padBody"));
    mode_->button(kWheels)->setObjectName(QStringLiteral("padWheels"));
    mode_->button(kBody)->setToolTip(tr("The sticks move the body: forward, to the left, turning."));
    mode_->button(kWheels)->setToolTip(tr("One stick for the wheels of each side."));
    auto* row = new QHBoxLayout(top);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    row->addWidget(pads_, 1);
    row->addWidget(mode_);
    row->addWidget(on_);
    connect(pads_, &QComboBox::activated, this, [this](int index) {
        const auto at = static_cast<std::size_t>(index);
        if (index >= 0 && at < pad_->pads().size()) pad_->choose(pad_->pads()[at]);
    });
    connect(on_, &QPushButton::clicked, pad_, &DrivePad::setOn);
    connect(mode_, &Segmented::asked, this, [this](int mode) { pad_->setDrivesWheels(mode == kWheels); });
    return top;
}

QWidget* DrivePadPanel::makeMap() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kGap);
    grid->setVerticalSpacing(4);
    int buttons = 0;
    int sticks = 0;
    for (std::size_t i = 0; i < kPadActions.size(); ++i) {
        const PadAction action = kPadActions.at(i);
        labels_.at(i) = new QLabel(actionText(action), box);
        auto* input = new QPushButton(box);
        input->setObjectName(QStringLiteral("padInput%1").arg(i + 1));
        input->setCheckable(true);
        input->setAutoDefault(false);
        input->setMinimumWidth(kInputWidth);
        connect(input, &QPushButton::clicked, this,
                [this, action](bool down) { pad_->learn(down ? std::optional(action) : std::nullopt); });
        inputs_.at(i) = input;
        if (action == PadAction::LeftWheels) sticks = 0;  // In the place of the body's.
        const int line = isStick(action) ? sticks++ : buttons++;
        const int column = isStick(action) ? 0 : 2;
        grid->addWidget(labels_.at(i), line, column);
        grid->addWidget(input, line, column + 1);
    }
    standard_ = new QPushButton(tr("Standard layout"), box);
    standard_->setObjectName(QStringLiteral("padStandard"));
    standard_->setAutoDefault(false);
    connect(standard_, &QPushButton::clicked, pad_, &DrivePad::setStandardMap);
    grid->addWidget(standard_, kMapRows - 1, 0, 1, 2, Qt::AlignLeft);
    grid->setRowStretch(kMapRows, 1);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return box;
}

QSpinBox* DrivePadPanel::makeNumber(const char* name, const QString& meaning, int lowest, int highest,
                                    int value) {
    auto* number = new SignedSpinBox(this);
    number->setObjectName(QString::fromLatin1(name));
    number->setRange(lowest, highest);
    number->setValue(value);
    number->setFixedWidth(kNumberWidth);
    number->setAccessibleName(meaning);
    return number;
}

QWidget* DrivePadPanel::makeFeel() {
    auto* box = new QWidget(this);
    const StickCurve& curve = pad_->curve();
    dead_ = makeNumber("padDeadZone", tr("Dead zone in percent"), 0, kWidestDeadZone_percent,
                       percent(curve.deadZone));
    bend_ = makeNumber("padBend", tr("Bend of the curve in percent"), 0, 100, percent(curve.bend));
    speed_ = makeNumber("padSpeed", tr("Speed of a stick at its end, in percent of the limit"), 1, 100,
                        pad_->speed_percent());
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    for (const auto& [words, number] :
         {std::pair{tr("Dead zone, %"), dead_}, std::pair{tr("Curve, %"), bend_},
          std::pair{tr("Full stick, % of limit"), speed_}}) {
        row->addWidget(new QLabel(words, box));
        row->addWidget(number);
        row->addSpacing(metrics::kGap);
    }
    row->addStretch(1);
    connect(dead_, &QSpinBox::valueChanged, this, &DrivePadPanel::setFeel);
    connect(bend_, &QSpinBox::valueChanged, this, &DrivePadPanel::setFeel);
    connect(speed_, &QSpinBox::valueChanged, pad_, &DrivePad::setSpeed);
    return box;
}

void DrivePadPanel::setFeel() {
    pad_->setCurve({dead_->value() / 100.0, bend_->value() / 100.0});
}

void DrivePadPanel::refresh() {
    if (!isVisible()) return;
    showPads();
    mode_->setCurrent(pad_->drivesWheels() ? kWheels : kBody);
    on_->setChecked(pad_->isOn());
    on_->setEnabled(pad_->isThere() || pad_->isOn());
    showMap();
    showPicture();
    const QString state = stateText();
    if (state_->text() != state) state_->setText(state);
    const bool heldUp = isHeldUp();
    sign_->setVisible(heldUp);
    state_->setFont(textFont(metrics::kTextSize, heldUp ? QFont::DemiBold : QFont::Normal));
    const thunderbots::RobotMask chosen = control_.summary().chosen;
    setNote(chosen == 0 ? tr("no robot chosen") : robotsText(chosen));
}

void DrivePadPanel::showPads() {
    QStringList names;
    int current = -1;
    for (const PadInfo& pad : pad_->pads()) {
        if (pad_->isThere() && pad.id == pad_->chosen().id) current = static_cast<int>(names.size());
        names << QString::fromStdString(pad.name);
    }
    if (names.isEmpty()) {
        names << tr("No gamepad is plugged in");
        current = 0;
    }
    QStringList shown;
    for (int i = 0; i < pads_->count(); ++i)
        shown << pads_->itemText(i);
    const QSignalBlocker blocker(pads_);
    if (shown != names) {
        pads_->clear();
        pads_->addItems(names);
    }
    if (pads_->currentIndex() != current) pads_->setCurrentIndex(current);
    pads_->setEnabled(!pad_->pads().empty());
}

void DrivePadPanel::showMap() {
    for (std::size_t i = 0; i < kPadActions.size(); ++i) {
        const PadAction action = kPadActions.at(i);
        const bool ofMode = isOfMode(action, pad_->drivesWheels());
        QPushButton* input = inputs_.at(i);
        labels_.at(i)->setVisible(ofMode);
        input->setVisible(ofMode);
        const bool learning = pad_->learning() == action;
        const QString stands = inputText(pad_->map().input(action), pad_->chosen().known);
        input->setText(!learning         ? stands
                       : isStick(action) ? tr("move a stick\u2026")
                                         : tr("press a button\u2026"));
        input->setChecked(learning);
        input->setEnabled(pad_->isThere());
        input->setAccessibleName(tr("%1: %2").arg(actionText(action), stands));
        input->setToolTip(isStick(action) ? tr("Click, then move the stick this way.")
                                          : tr("Click, then press the button."));
    }
    standard_->setEnabled(pad_->isThere());
}

void DrivePadPanel::showPicture() {
    picture_->show(pad_->curve(), pad_->positions(), pad_->isOn() && !pad_->awaitsNeutral());
}

QString DrivePadPanel::stateText() const {
    if (!pad_->notice().isEmpty()) return pad_->notice();
    if (!pad_->isThere()) return tr("Plug a gamepad in. It is found at once.");
    if (pad_->learning()) return tr("Nothing is driven while an input is being chosen.");
    if (!pad_->isOn()) return tr("It does not drive. Its STOP button counts all the same.");
    if (!control_.reasonNotToDrive().isEmpty()) return control_.reasonNotToDrive();
    if (pad_->awaitsNeutral()) return tr("Let go of both sticks: then they count.");
    return tr("It drives what is chosen. Letting the sticks go stops.");
}

bool DrivePadPanel::isHeldUp() const {
    if (!pad_->notice().isEmpty()) return true;
    if (!pad_->isOn() || pad_->learning()) return false;
    return !pad_->isThere() || (control_.reasonNotToDrive().isEmpty() && pad_->awaitsNeutral());
}

void DrivePadPanel::closed() {
    pad_->setOn(false);
}

void DrivePadPanel::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    refresh();
    // Looking for devices takes a moment: not before somebody wants one, and after the panel is painted.
    QTimer::singleShot(0, this, [this] {
        if (isVisible()) pad_->open();
    });
}

}  // namespace kickstand::ui
