#include "ui/thunderbots/kick_sweep_box.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/thunderbots/kick_diagram.h"
#include "ui/thunderbots/kick_words.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kColumns = 2;
constexpr int kLongestPause_s =
    static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(SweepPlan::kLongestPause).count());
constexpr int kFieldWidth = 56;

QString settingOf(const QObject* field) {
    return QStringLiteral("kick/%1").arg(field->objectName());
}

}  // namespace

KickSweepBox::KickSweepBox(QSettings& settings, QWidget* parent)
    : QWidget(parent),
      settings_(settings),
      solenoid_(new QComboBox(this)),
      buttons_(new QWidget(this)),
      start_(new QPushButton(tr("Start sweep"), buttons_)),
      stop_(new QPushButton(tr("Stop sweep"), buttons_)),
      progress_(new QLabel(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kGap);
    grid->setVerticalSpacing(4);
    solenoid_->addItem(QStringLiteral("1"), 1);
    solenoid_->addItem(QStringLiteral("2"), 2);
    solenoid_->setToolTip(tr("The other width and the offset stay as they are in the Kick panel."));
    addField(solenoid_, "sweepSolenoid", tr("Width"));
    count_ = addNumber("sweepCount", tr("Kicks"), 1, SweepPlan::kMostKicksPerStep, 1);
    from_ = addNumber("sweepFrom", tr("From, \u00b5s"), 0, wire::kKickMax_us, 640);
    to_ = addNumber("sweepTo", tr("To, \u00b5s"), 0, wire::kKickMax_us, 2560);
    step_ = addNumber("sweepStep", tr("Step, \u00b5s"), wire::kKickStep_us, wire::kKickMax_us, 320);
    pause_ = addNumber("sweepPause", tr("Pause, s"), 0, kLongestPause_s, 0);
    pause_->setToolTip(
        tr("At least so long from kick to kick. A kick always waits for a charged capacitor."));
    count_->setToolTip(tr("Kicks with each width."));
    for (SignedSpinBox* field : {from_, to_, step_})
        watch(field, true);
    for (SignedSpinBox* field : {count_, pause_})
        watch(field, false);
    makeButtons();
    progress_->setObjectName(QStringLiteral("sweepProgress"));
    progress_->setWordWrap(true);
    progress_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    const int row = fields_ / kColumns;
    grid->addWidget(progress_, row, 0, 1, 2 * kColumns);
    grid->setRowStretch(row, 1);
    solenoid_->setCurrentIndex(std::clamp(settings_.value(settingOf(solenoid_)).toInt(), 0, 1));
    connect(solenoid_, &QComboBox::currentIndexChanged, this, [this](int index) {
        settings_.setValue(settingOf(solenoid_), index);
        emit edited();
    });
}

void KickSweepBox::makeButtons() {
    start_->setObjectName(QStringLiteral("sweepStart"));
    stop_->setObjectName(QStringLiteral("sweepStop"));
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QPushButton* button : {start_, stop_}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(start_, &QPushButton::clicked, this, &KickSweepBox::startAsked);
    connect(stop_, &QPushButton::clicked, this, &KickSweepBox::stopAsked);
}

void KickSweepBox::addField(QWidget* field, const char* name, const QString& label) {
    field->setObjectName(QString::fromLatin1(name));
    field->setAccessibleName(label);
    auto* words = new QLabel(label, this);
    words->setBuddy(field);
    words->setForegroundRole(QPalette::PlaceholderText);
    auto* grid = static_cast<QGridLayout*>(layout());
    const int row = fields_ / kColumns;
    const int column = fields_ % kColumns * 2;
    grid->addWidget(words, row, column);
    grid->addWidget(field, row, column + 1);
    ++fields_;
}

SignedSpinBox* KickSweepBox::addNumber(const char* name, const QString& label, int lowest, int highest,
                                       int value) {
    auto* field = new SignedSpinBox(this);
    addField(field, name, label);
    field->setFont(numberFont(metrics::kTextSize));
    field->setMinimumWidth(kFieldWidth);
    field->setRange(lowest, highest);
    field->setValue(settings_.value(settingOf(field), value).toInt());
    return field;
}

void KickSweepBox::watch(SignedSpinBox* field, bool grid) {
    if (grid) field->setSingleStep(wire::kKickStep_us);
    if (grid) field->setValue(onGrid(field->value()));
    connect(field, &QSpinBox::valueChanged, this, [this, field, grid](int value) {
        if (grid && onGrid(value) != value) {
            // Comes here again.
            field->setValue(onGrid(value));
            return;
        }
        settings_.setValue(settingOf(field), value);
        emit edited();
    });
}

SweepPlan KickSweepBox::plan(int robot, const wire::KickPulses& pulses) const {
    SweepPlan plan;
    plan.robot = robot;
    plan.solenoid = solenoid_->currentData().toInt();
    plan.from_us = from_->value();
    plan.to_us = to_->value();
    plan.step_us = step_->value();
    plan.otherWidth_us = plan.solenoid == 1 ? pulses.width2_us : pulses.width1_us;
    plan.offset_us = pulses.offset_us;
    plan.kicksPerStep = count_->value();
    plan.pause = std::chrono::seconds(pause_->value());
    return plan;
}

void KickSweepBox::showState(const std::optional<SweepProgress>& sweep, const QString& reason,
                             const QString& outlook) {
    const bool running = sweep && sweep->running();
    for (QWidget* field :
         {static_cast<QWidget*>(solenoid_), static_cast<QWidget*>(from_), static_cast<QWidget*>(to_),
          static_cast<QWidget*>(step_), static_cast<QWidget*>(count_), static_cast<QWidget*>(pause_)})
        field->setEnabled(!running);
    start_->setEnabled(!running && reason.isEmpty());
    start_->setToolTip(reason.isEmpty() ? outlook : reason);
    stop_->setEnabled(running);
    setButtonRole(stop_, running ? ButtonRole::Primary : ButtonRole::Normal);
    QString text = running ? sweepText(*sweep) : reason.isEmpty() ? outlook : reason;
    if (!running && sweep) text = sweepText(*sweep) + u'\n' + text;
    progress_->setText(text);
    progress_->setToolTip(text);
    progress_->setForegroundRole(running ? QPalette::WindowText : QPalette::PlaceholderText);
}

}  // namespace kickstand::ui
