#include "app/composition/user_catalogue.h"

#include <QFile>
#include <QStandardPaths>

namespace kickstand {
namespace {

/// One more than a catalogue may have.
constexpr qint64 kMostBytes = (1 << 20) + 1;

}  // namespace

UserCatalogue readUserCatalogue() {
    const bool named = qEnvironmentVariableIsSet("KICKSTAND_DEVICES");
    const QString path = named ? QFile::decodeName(qgetenv("KICKSTAND_DEVICES"))
                               : QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
                                     QStringLiteral("/kickstand/devices.json");
    QFile file(path);
    if (!file.exists() && !named) return {};
    UserCatalogue catalogue;
    catalogue.source = path.toStdString();
    // A file that was named and cannot be read is no catalogue, and that is to be said.
    catalogue.text = file.open(QIODevice::ReadOnly) ? file.read(kMostBytes).toStdString() : std::string(" ");
    return catalogue;
}

}  // namespace kickstand
