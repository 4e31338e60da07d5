#include "ui/widgets/open_file.h"

#include <QFileDialog>

namespace kickstand::ui {

void askToOpen(QWidget* parent, const QString& title, const QStringList& filters,
               const std::function<void(const QStringList& paths)>& chosen) {
    auto* dialog = new QFileDialog(parent, title);
    dialog->setObjectName(QStringLiteral("openFilesDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters(filters);
    QObject::connect(dialog, &QFileDialog::filesSelected, parent, chosen);
    dialog->open();
}

}  // namespace kickstand::ui
