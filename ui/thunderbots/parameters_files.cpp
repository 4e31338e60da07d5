// What the panel does with files and with earlier readings.

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>

#include "core/engine/describe_facts.h"
#include "core/engine/describe_parameter_file.h"
#include "core/engine/describe_parameters.h"
#include "core/ledger/ledger.h"
#include "ui/thunderbots/parameters_history.h"
#include "ui/thunderbots/parameters_panel.h"
#include "ui/widgets/save_file.h"

namespace kickstand::ui {

using namespace thunderbots;

void ParametersPanel::openFile() {
    auto* dialog = new QFileDialog(this, tr("Open parameters"));
    dialog->setObjectName(QStringLiteral("openDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // The program's own, so that STOP keys reach it.
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("JSON files (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, &ParametersPanel::readFile);
    dialog->open();
}

void ParametersPanel::readFile(const QString& path) {
    QFile file(path);
    refusal_.clear();
    if (!file.open(QIODevice::ReadOnly)) {
        refusal_ = tr("%1 cannot be read: %2.").arg(path, file.errorString());
    } else if (const auto values = readParameterFile(file.read(kLongestParameterFile + 1)); !values) {
        refusal_ = describe(values.error()).line();
    } else {
        showOther(*values, QFileInfo(path).fileName());
    }
    refresh();
}

void ParametersPanel::saveFile() {
    askToSave(this, tr("Save parameters"), QStringLiteral("robot%1.json").arg(robot_), QStringLiteral("json"),
              [this] {
                  ParameterValues values;
                  for (const ParameterField field : kParameterFields)
                      values[static_cast<std::size_t>(field)] = draft().value(field);
                  return writeParameterFile(values);
              });
}

void ParametersPanel::showOther(const ParameterValues& values, const QString& title) {
    other() = {values, title};
    refresh();
}

std::optional<ParameterValues> ParametersPanel::selectedValues() {
    const ParameterRecord* record = history_->selected();
    if (record == nullptr) return std::nullopt;
    const auto block = wire::decodeParameters(record->block);
    if (block) return valuesOf(*block);
    refusal_ = tr("That reading is no block of parameters.");
    refresh();
    return std::nullopt;
}

void ParametersPanel::compare() {
    if (const auto values = selectedValues()) showOther(*values, recordTime(*history_->selected()));
}

void ParametersPanel::restore() {
    const auto values = selectedValues();
    if (!values) return;
    draft().take(*values, kSettings);
    showOther(*values, recordTime(*history_->selected()));
}

void ParametersPanel::editNote() {
    const ParameterRecord* record = history_->selected();
    if (record == nullptr) return;
    auto* dialog = new QInputDialog(window());
    dialog->setObjectName(QStringLiteral("askLine"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::TextInput);
    dialog->setWindowTitle(tr("Note"));
    dialog->setLabelText(tr("What to remember of this reading"));
    dialog->setTextValue(printable(record->note));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, id = record->id](const QString& note) { ledger_.setNote(id, note.toStdString()); });
    dialog->open();
}

}  // namespace kickstand::ui
