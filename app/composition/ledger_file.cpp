#include "app/composition/ledger_file.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace kickstand {

std::string ledgerFile() {
    if (qEnvironmentVariableIsSet("KICKSTAND_LEDGER")) return qgetenv("KICKSTAND_LEDGER").toStdString();
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    const QDir folder(data + QStringLiteral("/kickstand"));
    if (data.isEmpty() || !folder.mkpath(QStringLiteral("."))) return ":memory:";
    return QFile::encodeName(folder.filePath(QStringLiteral("fleet.sqlite"))).toStdString();
}

}  // namespace kickstand
