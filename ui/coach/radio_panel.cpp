#include "ui/coach/radio_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/engine/describe_coach.h"
#include "ui/coach/coach_view.h"
#include "ui/shell/bench.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace coach;

namespace {

enum Preset { kCoachPreset, kTowrpPreset, kDongle0, kDongle1, kRobot0, kRobot1 };

QSpinBox* hexBox(const char* name, int lowest, int highest, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setObjectName(QString::fromLatin1(name));
    box->setRange(lowest, highest);
    box->setDisplayIntegerBase(16);
    box->setPrefix(QStringLiteral("0x"));
    box->setFont(numberFont(metrics::kTextSize));
    return box;
}

}  // namespace

RadioPanel::RadioPanel(Bench& bench, QWidget* parent)
    : Panel(bench, parent),
      state_(new QLabel(this)),
      find_(new QPushButton(tr("Find the module"), this)),
      preset_(new QComboBox(this)),
      number_(new QSpinBox(this)),
      use_(new QPushButton(tr("Use preset"), this)),
      address_(hexBox("radioAddress", 0, 0xFFFF, this)),
      channel_(hexBox("radioChannel", 0x0B, 0x1A, this)),
      pan_(hexBox("radioPan", 0, 0xFFFF, this)),
      mode_(new QComboBox(this)),
      baud_(new QComboBox(this)),
      name_(new QLineEdit(this)),
      changes_(new QLabel(this)),
      apply_(new QPushButton(tr("Apply"), this)),
      undo_(new QPushButton(tr("Undo"), this)) {
    build();
    connect(find_, &QPushButton::clicked, this, [this] { submit(FindRadio{}); });
    connect(use_, &QPushButton::clicked, this, &RadioPanel::usePreset);
    connect(apply_, &QPushButton::clicked, this, [this] { submit(ApplyRadio{draft()}); });
    connect(undo_, &QPushButton::clicked, this, [this] {
        if (read_) showDraft(*read_);
    });
    for (QSpinBox* box : {address_, channel_, pan_})
        connect(box, &QSpinBox::valueChanged, this, &RadioPanel::showChanges);
    for (QComboBox* box : {mode_, baud_})
        connect(box, &QComboBox::currentIndexChanged, this, &RadioPanel::showChanges);
    connect(name_, &QLineEdit::textChanged, this, &RadioPanel::showChanges);
    connect(&bench, &Bench::changed, this, &RadioPanel::refresh);
    refresh();
}

void RadioPanel::build() {
    find_->setObjectName(QStringLiteral("radioFind"));
    preset_->setObjectName(QStringLiteral("radioPreset"));
    preset_->setAccessibleName(tr("Preset"));
    preset_->addItems({tr("COACH of team"), tr("TOWRP of team"), tr("Thunderbots dongle, radio 0"),
                       tr("Thunderbots dongle, radio 1"), tr("Thunderbots robot, radio 0"),
                       tr("Thunderbots robot, radio 1")});
    number_->setObjectName(QStringLiteral("radioNumber"));
    number_->setRange(0, 255);
    number_->setAccessibleName(tr("Team or robot of the preset"));
    use_->setObjectName(QStringLiteral("radioUse"));
    mode_->setObjectName(QStringLiteral("radioMode"));
    for (const ModuleMode mode : {ModuleMode::Transparent, ModuleMode::Api, ModuleMode::ApiEscaped})
        mode_->addItem(describe(mode));
    baud_->setObjectName(QStringLiteral("radioBaud"));
    for (const Baud baud : kModuleBauds)
        baud_->addItem(QString::number(baud), baud);
    baud_->addItem(QString::number(kThunderbotsBaud), kThunderbotsBaud);
    name_->setObjectName(QStringLiteral("radioName"));
    name_->setMaxLength(static_cast<int>(kMaxNodeName));
    changes_->setObjectName(QStringLiteral("radioChanges"));
    apply_->setObjectName(QStringLiteral("radioApply"));
    undo_->setObjectName(QStringLiteral("radioUndo"));
    state_->setObjectName(QStringLiteral("radioState"));
    state_->setWordWrap(true);
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->addRow(tr("Address"), address_);
    form->addRow(tr("Channel"), channel_);
    form->addRow(tr("Network (PAN)"), pan_);
    form->addRow(tr("Mode"), mode_);
    form->addRow(tr("Baud"), baud_);
    form->addRow(tr("Node name"), name_);
    for (QWidget* field : std::initializer_list<QWidget*>{address_, channel_, pan_, mode_, baud_, name_})
        field->setAccessibleName(qobject_cast<QLabel*>(form->labelForField(field))->text());
    auto* presets = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{preset_, number_, use_})
        presets->addWidget(widget);
    presets->addStretch(1);
    auto* ends = new QHBoxLayout;
    for (QWidget* widget : std::initializer_list<QWidget*>{apply_, undo_, changes_})
        ends->addWidget(widget);
    ends->addStretch(1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    all->setSpacing(metrics::kGap);
    all->addWidget(state_);
    all->addWidget(find_, 0, Qt::AlignLeft);
    all->addLayout(presets);
    all->addLayout(form);
    all->addLayout(ends);
    all->addStretch(1);
}

void RadioPanel::submit(const coach::Command& command) {
    bench().submit(SystemCommand{command});
}

RadioSettings RadioPanel::draft() const {
    RadioSettings settings;
    settings.address = static_cast<std::uint16_t>(address_->value());
    settings.channel = static_cast<std::uint8_t>(channel_->value());
    settings.pan = static_cast<std::uint16_t>(pan_->value());
    settings.mode = static_cast<ModuleMode>(mode_->currentIndex());
    settings.baud = baud_->currentData().toUInt();
    settings.name = name_->text().toStdString();
    return settings;
}

void RadioPanel::showDraft(const RadioSettings& settings) {
    address_->setValue(settings.address);
    channel_->setValue(settings.channel);
    pan_->setValue(settings.pan);
    mode_->setCurrentIndex(static_cast<int>(settings.mode));
    if (baud_->findData(settings.baud) < 0) baud_->addItem(QString::number(settings.baud), settings.baud);
    baud_->setCurrentIndex(baud_->findData(settings.baud));
    name_->setText(QString::fromStdString(settings.name));
    showChanges();
}

void RadioPanel::usePreset() {
    const RadioSettings present = draft();
    const int number = number_->value();
    const int robot = number % 16;
    switch (preset_->currentIndex()) {
        case kCoachPreset:
            return showDraft(presetFor(wire::Role::Coach, static_cast<Team>(number), present));
        case kTowrpPreset:
            return showDraft(presetFor(wire::Role::Towrp, static_cast<Team>(number), present));
        case kDongle0:
        case kDongle1:
            return showDraft(thunderbotsPreset(std::nullopt, preset_->currentIndex() - kDongle0, present));
        default:
            return showDraft(thunderbotsPreset(robot, preset_->currentIndex() - kRobot0, present));
    }
}

void RadioPanel::showChanges() {
    const bool changed = read_ && draft() != *read_;
    changes_->setText(changed ? tr("Changed, not applied") : QString());
    const Snapshot* snapshot = coachOf(bench().session());
    const bool may =
        snapshot != nullptr && snapshot->radio && !snapshot->role && snapshot->link != LinkState::Setting;
    apply_->setEnabled(may && changed);
    undo_->setEnabled(changed);
}

void RadioPanel::refresh() {
    const Snapshot* snapshot = coachOf(bench().session());
    const bool open = snapshot != nullptr &&
                      (snapshot->link == LinkState::Running || snapshot->link == LinkState::NoModule);
    find_->setEnabled(open && !snapshot->role);
    if (snapshot == nullptr) {
        state_->setText(tr("No serial port with an XBee adapter is connected."));
        read_.reset();
    } else if (snapshot->link == LinkState::Setting) {
        state_->setText(tr("Working, now at %1 baud").arg(snapshot->tries));
    } else if (!snapshot->radio) {
        state_->setText(
            tr("%1. Find it: at every usual speed and in every mode.").arg(describe(snapshot->link)));
    } else {
        const RadioIdentity& identity = snapshot->radio->identity;
        state_->setText(tr("%1, %2, serial number %3, firmware %4")
                            .arg(describe(snapshot->link), describeAddress(snapshot->radio->settings.address))
                            .arg(identity.serial, 16, 16, QLatin1Char('0'))
                            .arg(identity.firmware, 4, 16, QLatin1Char('0')));
        if (read_ != snapshot->radio->settings) {
            read_ = snapshot->radio->settings;
            showDraft(*read_);
        }
    }
    showChanges();
}

}  // namespace kickstand::ui
