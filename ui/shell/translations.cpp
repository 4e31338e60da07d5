#include "ui/shell/translations.h"

#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <QTranslator>

namespace kickstand::ui {

void installTranslations() {
    const QDir program(QCoreApplication::applicationDirPath());
    auto* words = new QTranslator(QCoreApplication::instance());
    for (const QString& place : {program.filePath(QStringLiteral("../share/kickstand/translations")),
                                 program.filePath(QStringLiteral("translations"))}) {
        if (!words->load(QLocale(), QStringLiteral("kickstand"), QStringLiteral("_"), place)) continue;
        QCoreApplication::installTranslator(words);
        return;
    }
    delete words;
}

}  // namespace kickstand::ui
