#include "ui/thunderbots/kick_preset_box.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/thunderbots/kick_settings.h"
#include "ui/thunderbots/kick_words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kNamesWidth = 150;

}  // namespace

QInputDialog* askLine(QWidget* parent, const QString& title, const QString& label, const QString& first) {
    auto* dialog = new QInputDialog(parent->window());
    dialog->setObjectName(QStringLiteral("askLine"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::TextInput);
    dialog->setWindowTitle(title);
    dialog->setLabelText(label);
    dialog->setTextValue(first);
    return dialog;
}

KickPresetBox::KickPresetBox(KickSettings& kick, QSettings& settings, QWidget* parent)
    : QWidget(parent), kick_(kick), presets_(settings), names_(new QComboBox(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    names_->setObjectName(QStringLiteral("kickPresets"));
    names_->setAccessibleName(tr("Preset"));
    names_->setFixedWidth(kNamesWidth);
    auto* more = new QPushButton(tr("Preset"), this);
    more->setObjectName(QStringLiteral("presetMenu"));
    more->setAccessibleName(tr("Save, rename or delete a preset"));
    more->setAutoDefault(false);
    auto* menu = new QMenu(more);
    QAction* save = menu->addAction(tr("Save as\u2026"));
    save->setObjectName(QStringLiteral("presetSave"));
    rename_ = menu->addAction(tr("Rename\u2026"));
    rename_->setObjectName(QStringLiteral("presetRename"));
    remove_ = menu->addAction(tr("Delete"));
    remove_->setObjectName(QStringLiteral("presetDelete"));
    more->setMenu(menu);
    row->addWidget(names_);
    row->addWidget(more);
    connect(names_, &QComboBox::activated, this, &KickPresetBox::choose);
    connect(save, &QAction::triggered, this,
            [this] { askName(tr("Save preset"), current(), [this](const QString& name) { saveAs(name); }); });
    connect(rename_, &QAction::triggered, this, [this] {
        askName(tr("Rename preset"), current(), [this, from = current()](const QString& name) {
            if (presets_.rename(from, name)) chosen_ = KickPresets::tidied(name);
        });
    });
    connect(remove_, &QAction::triggered, this, [this] {
        presets_.remove(current());
        refresh();
    });
    connect(&kick_, &KickSettings::changed, this, &KickPresetBox::refresh);
    refresh();
}

void KickPresetBox::refresh() {
    const QSignalBlocker blocker(names_);
    names_->clear();
    names_->addItem(tr("No preset"));
    int now = 0;
    for (const KickPreset& preset : presets_.all()) {
        names_->addItem(preset.name, preset.name);
        names_->setItemData(names_->count() - 1, pulsesText(preset.pulses), Qt::ToolTipRole);
        if (preset.pulses == kick_.pulses() && (now == 0 || preset.name == chosen_))
            now = names_->count() - 1;
    }
    names_->setCurrentIndex(now);
    rename_->setEnabled(now > 0);
    remove_->setEnabled(now > 0);
}

void KickPresetBox::choose(int index) {
    const KickPreset* preset = presets_.find(names_->itemData(index).toString());
    if (preset != nullptr) {
        chosen_ = preset->name;
        kick_.setPulses(preset->pulses);
    }
    refresh();
}

QString KickPresetBox::current() const {
    return names_->currentData().toString();
}

void KickPresetBox::askName(const QString& title, const QString& first,
                            const std::function<void(const QString&)>& named) {
    QInputDialog* dialog = askLine(this, title, tr("Name"), first);
    connect(dialog, &QInputDialog::textValueSelected, this, [this, named](const QString& name) {
        named(name);
        refresh();
    });
    dialog->open();
}

void KickPresetBox::saveAs(const QString& name) {
    const KickPreset* there = presets_.find(KickPresets::tidied(name));
    if (there == nullptr || there->pulses == kick_.pulses()) return keep(name);
    auto* box = new QMessageBox(
        QMessageBox::Question, tr("Save preset"),
        tr("There is a preset \u201c%1\u201d already: %2.").arg(there->name, pulsesText(there->pulses)),
        QMessageBox::Cancel, window());
    box->setObjectName(QStringLiteral("replacePreset"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* replace = box->addButton(tr("Replace it"), QMessageBox::AcceptRole);
    connect(replace, &QPushButton::clicked, this, [this, name] { keep(name); });
    box->open();
}

void KickPresetBox::keep(const QString& name) {
    if (presets_.save(name, kick_.pulses())) chosen_ = KickPresets::tidied(name);
    refresh();
}

}  // namespace kickstand::ui
