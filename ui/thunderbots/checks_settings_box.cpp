#include "ui/thunderbots/checks_settings_box.h"

#include <QCheckBox>
#include <QFile>
#include <QFileDialog>
#include <QGridLayout>
#include <QJsonDocument>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>
#include <cmath>

#include "core/engine/describe_check.h"
#include "core/engine/describe_check_report.h"
#include "ui/thunderbots/wheel_unit.h"
#include "ui/widgets/save_file.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kFieldWidth = 52;
constexpr qint64 kLargestFile = 1 << 16;

QString settingOf(const char* name) {
    return QStringLiteral("checks/%1").arg(QLatin1String(name));
}

double scaleOf(const CheckLimitInfo& info) {
    return std::pow(10, info.decimals);
}

int toField(const CheckLimitInfo& info, double value) {
    return static_cast<int>(std::lround(value * scaleOf(info)));
}

}  // namespace

ChecksSettingsBox::ChecksSettingsBox(QSettings& settings, QWidget* parent)
    : QWidget(parent), settings_(settings) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(makeParts());
    column->addWidget(makeLimits());
    column->addWidget(makeFiles());
    column->addStretch(1);
}

QWidget* ChecksSettingsBox::makeParts() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    addPart(box, "wheels", tr("Wheels"), &CheckPlan::wheels);
    addPart(box, "dribbler", tr("Dribbler"), &CheckPlan::dribbler);
    addPart(box, "kicker", tr("Charge and kick"), &CheckPlan::highVoltage);
    addPart(box, "leds", tr("Test LEDs"), &CheckPlan::lights);
    return box;
}

void ChecksSettingsBox::addPart(QWidget* parent, const char* name, const QString& text,
                                bool CheckPlan::*member) {
    auto* box = new QCheckBox(text, parent);
    box->setObjectName(QStringLiteral("checks_%1").arg(QLatin1String(name)));
    box->setChecked(settings_.value(settingOf(name), true).toBool());
    auto* grid = static_cast<QGridLayout*>(parent->layout());
    const int place = static_cast<int>(parts_.size());
    grid->addWidget(box, place / 2, place % 2);
    parts_.push_back({box, member});
    connect(box, &QCheckBox::toggled, this, [this, name](bool on) {
        settings_.setValue(settingOf(name), on);
        emit edited();
    });
}

QWidget* ChecksSettingsBox::makeLimits() {
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kGap);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    int row = 0;
    for (const CheckLimitInfo& info : checkLimitInfos()) {
        const QString unit = QString::fromUtf8(info.unit);
        SignedSpinBox* field = makeField(info, box);
        auto* label = new QLabel(unit.isEmpty() ? labelOf(info) : tr("%1, %2").arg(labelOf(info), unit), box);
        if (info.member == &CheckLimits::wheelSpeed) {
            const auto follow = [label, &info](int units) {
                label->setText(
                    tr("%1, units (%2)").arg(labelOf(info), wheelSpeedText(units, WheelUnit::Rpm)));
            };
            follow(field->value());
            connect(field, &QSpinBox::valueChanged, label, follow);
        }
        label->setBuddy(field);
        label->setForegroundRole(QPalette::PlaceholderText);
        grid->addWidget(label, row, 0);
        grid->addWidget(field, row, 1);
        ++row;
    }
    return box;
}

SignedSpinBox* ChecksSettingsBox::makeField(const CheckLimitInfo& info, QWidget* parent) {
    auto* field = new SignedSpinBox(parent);
    field->setObjectName(QStringLiteral("checks_%1").arg(QLatin1String(info.name)));
    field->setAccessibleName(labelOf(info));
    field->setFont(numberFont(metrics::kTextSize));
    field->setFixedWidth(kFieldWidth);
    field->setRange(toField(info, info.lowest), toField(info, info.highest));
    field->setDecimals(info.decimals);
    field->setValue(
        toField(info, settings_.value(settingOf(info.name), CheckLimits{}.*info.member).toDouble()));
    fields_.push_back(field);
    connect(field, &QSpinBox::valueChanged, this, [this, &info](int value) {
        settings_.setValue(settingOf(info.name), value / scaleOf(info));
        emit edited();
    });
    return field;
}

QWidget* ChecksSettingsBox::makeFiles() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 2, 0, 0);
    row->setSpacing(4);
    auto* load = new QPushButton(tr("Load\u2026"), box);
    load->setObjectName(QStringLiteral("checksLoadLimits"));
    load->setToolTip(tr("Reads limits from a file."));
    auto* save = new QPushButton(tr("Save\u2026"), box);
    save->setObjectName(QStringLiteral("checksSaveLimits"));
    save->setToolTip(tr("Saves these limits as a file; the command line takes it too."));
    auto* usual = new QPushButton(tr("Usual"), box);
    usual->setObjectName(QStringLiteral("checksUsualLimits"));
    usual->setToolTip(tr("Back to the limits that the program came with."));
    for (QPushButton* button : {load, save, usual}) {
        button->setAutoDefault(false);
        row->addWidget(button, 1);
    }
    connect(load, &QPushButton::clicked, this, &ChecksSettingsBox::askToLoad);
    connect(save, &QPushButton::clicked, this, [this] {
        askToSave(this, tr("Save limits"), QStringLiteral("limits.json"), QStringLiteral("json"),
                  [this] { return QJsonDocument(toJson(plan(0).limits)).toJson(); });
    });
    connect(usual, &QPushButton::clicked, this, [this] { setLimits({}); });
    return box;
}

void ChecksSettingsBox::askToLoad() {
    auto* dialog = new QFileDialog(this, tr("Load limits"));
    dialog->setObjectName(QStringLiteral("loadDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // The program's own, so that STOP keys reach the program while it is open.
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Limits (*.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &ChecksSettingsBox::load);
    dialog->open();
}

void ChecksSettingsBox::load(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        emit refused(tr("%1 cannot be read: %2.").arg(path, file.errorString()));
        return;
    }
    const auto limits = checkLimitsFromJson(file.read(kLargestFile));
    if (!limits) {
        emit refused(limits.error());
        return;
    }
    setLimits(*limits);
    emit refused({});
}

CheckPlan ChecksSettingsBox::plan(RobotMask robots) const {
    CheckPlan plan;
    plan.robots = robots;
    for (const Part& part : parts_)
        plan.*part.member = part.box->isChecked();
    std::size_t place = 0;
    for (const CheckLimitInfo& info : checkLimitInfos())
        plan.limits.*info.member = fields_[place++]->value() / scaleOf(info);
    return plan;
}

void ChecksSettingsBox::setLimits(const CheckLimits& limits) {
    std::size_t place = 0;
    for (const CheckLimitInfo& info : checkLimitInfos())
        fields_[place++]->setValue(toField(info, limits.*info.member));
}

}  // namespace kickstand::ui
