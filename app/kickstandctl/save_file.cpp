#include "app/kickstandctl/save_file.h"

#include <QSaveFile>

#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::ctl {

Outcome saveFile(const QString& path, const QByteArray& content) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(content) == content.size() && file.commit()) return {};
    return tl::unexpected<Failure>(
        {kFailed,
         {Words::tr("“%1” cannot be written: %2.").arg(printable(path.toStdString()), file.errorString()),
          Words::tr("Check the place and the room on it."),
          {}},
         QStringLiteral("file-not-written")});
}

}  // namespace kickstand::ctl
