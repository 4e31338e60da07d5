#include "ui/widgets/save_file.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QSaveFile>

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SaveFile)
};

void write(QWidget* parent, const QString& path, const QByteArray& content) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(content) == content.size() && file.commit()) return;
    auto* box = new QMessageBox(QMessageBox::Warning, Words::tr("Not saved"),
                                Words::tr("%1 could not be written: %2.").arg(path, file.errorString()),
                                QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace

void askToSave(QWidget* parent, const QString& title, const QString& name, const QString& suffix,
               const std::function<QByteArray()>& content) {
    auto* dialog = new QFileDialog(parent, title);
    dialog->setObjectName(QStringLiteral("saveDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->setNameFilter(Words::tr("%1 files (*.%2)").arg(suffix.toUpper(), suffix));
    dialog->selectFile(name);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent,
                     [parent, content](const QString& path) { write(parent, path, content()); });
    dialog->open();
}

}  // namespace kickstand::ui
