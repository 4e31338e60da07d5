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

constexpr int kFieldWidth = 200;
constexpr int kHighestRobot = 15;

QString hex(unsigned value, int digits) {
    return QStringLiteral("0x%1").arg(value, digits, 16, QLatin1Char('0'));
}

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
      notice_(new QLabel(this)),
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
    notice_->setObjectName(QStringLiteral("radioNotice"));
    notice_->setWordWrap(true);
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    const std::array<std::pair<QString, QWidget*>, 6> fields{{{tr("Address"), address_},
                                                              {tr("Channel"), channel_},
                                                              {tr("Network (PAN)"), pan_},
                                                              {tr("Mode"), mode_},
                                                              {tr("Baud"), baud_},
                                                              {tr("Node name"), name_}}};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto& [words, field] = fields.at(i);
        field->setAccessibleName(words);
        field->setFixedWidth(kFieldWidth);
        held_.at(i) = new QLabel(this);
        held_.at(i)->setObjectName(QStringLiteral("radioHeld%1").arg(i));
        auto* row = new QHBoxLayout;
        row->addWidget(field);
        row->addWidget(held_.at(i), 1);
        form->addRow(words, row);
    }
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
    all->addWidget(notice_);
    all->addStretch(1);
}

void RadioPanel::submit(const coach::Command& command) {
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        notice_->setText(result ? QString() : describe(result.error()).line());
    });
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
    notice_->clear();
    switch (preset_->currentIndex()) {
        case kCoachPreset:
            return showDraft(presetFor(wire::Role::Coach, static_cast<Team>(number), present));
        case kTowrpPreset:
            return showDraft(presetFor(wire::Role::Towrp, static_cast<Team>(number), present));
        case kDongle0:
        case kDongle1:
            return showDraft(thunderbotsPreset(std::nullopt, preset_->currentIndex() - kDongle0, present));
        default:
            if (number <= kHighestRobot)
                return showDraft(thunderbotsPreset(number, preset_->currentIndex() - kRobot0, present));
            notice_->setText(describe(Error{.code = Errc::OutOfRange,
                                            .subject = "robot",
                                            .lowest = 0,
                                            .highest = kHighestRobot,
                                            .got = number})
                                 .line());
    }
}

void RadioPanel::showHeld(const RadioSettings& draft) {
    const RadioSettings held = read_.value_or(draft);
    const std::array<QString, 6> texts{draft.address == held.address ? QString() : hex(held.address, 4),
                                       draft.channel == held.channel ? QString() : hex(held.channel, 2),
                                       draft.pan == held.pan ? QString() : hex(held.pan, 4),
                                       draft.mode == held.mode ? QString() : describe(held.mode),
                                       draft.baud == held.baud ? QString() : QString::number(held.baud),
                                       draft.name == held.name ? QString()
                                       : held.name.empty()     ? tr("none")
                                                               : QString::fromStdString(held.name)};
    for (std::size_t i = 0; i < texts.size(); ++i)
        held_.at(i)->setText(texts.at(i).isEmpty() ? QString()
                                                   : tr("changed; the module has %1").arg(texts.at(i)));
}

void RadioPanel::showChanges() {
    const RadioSettings wanted = draft();
    const bool changed = read_ && wanted != *read_;
    showHeld(wanted);
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
        const RadioSettings& held = snapshot->radio->settings;
        const QString found = held.mode == ModuleMode::Transparent
                                  ? tr("radio module found, not in API mode yet")
                                  : describe(snapshot->link);
        state_->setText(tr("%1, %2, serial number %3, firmware %4")
                            .arg(found, describeAddress(held.address))
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
