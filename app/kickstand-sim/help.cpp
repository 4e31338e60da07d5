#include "app/kickstand-sim/help.h"

#include <algorithm>

#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

QString translated(const char* text) {
    return *text == '\0' ? QString() : QCoreApplication::translate("kickstand_sim", text);
}

/// Lines of two columns, the first as wide as it has to be.
QString columns(const QList<QPair<QString, QString>>& rows) {
    qsizetype width = 0;
    for (const auto& row : rows)
        width = std::max(width, row.first.size());
    QString text;
    for (const auto& row : rows)
        text += QStringLiteral("  %1  %2\n").arg(row.first.leftJustified(width), row.second);
    return text;
}

QString exampleLine(const char* example) {
    return Words::tr("Example: %1").arg(QStringLiteral("kickstand-sim ") + QString::fromUtf8(example)) +
           QLatin1Char('\n');
}

QString overview() {
    QList<QPair<QString, QString>> rows;
    for (const CommandSpec& command : commands())
        rows.append({QString::fromUtf8(command.name), translated(command.summary)});
    return Words::tr("kickstand-sim: simulated robots, served to any program.") + QStringLiteral("\n\n") +
           Words::tr("Usage: kickstand-sim NAME [OPTION …]") + QStringLiteral("\n\n") + columns(rows) +
           QLatin1Char('\n') +
           columns({{QStringLiteral("--help"), Words::tr("this; after a name, help on that")},
                    {QStringLiteral("--version"), Words::tr("which version this is")}}) +
           QLatin1Char('\n') + exampleLine("thunderbots --usbip --robots 0,3,5") +
           Words::tr("Exit: 0 done, or told to end; 1 it failed or was refused; 2 bad usage.") +
           QLatin1Char('\n');
}

QString commandHelp(const CommandSpec& command) {
    QList<QPair<QString, QString>> rows;
    for (const OptionSpec& option : command.options) {
        QString name = QString::fromUtf8(option.name);
        if (*option.value != '\0') name += QLatin1Char(' ') + QString::fromUtf8(option.value);
        rows.append({name, translated(option.help)});
    }
    QString usage = QStringLiteral("kickstand-sim %1 [OPTION …]").arg(QString::fromUtf8(command.name));
    if (*command.operands != '\0') usage += QLatin1Char(' ') + translated(command.operands);
    return Words::tr("Usage: %1").arg(usage) + QStringLiteral("\n\n") + translated(command.summary) +
           QLatin1Char('\n') + translated(command.details) + QStringLiteral("\n\n") + Words::tr("Options:") +
           QLatin1Char('\n') + columns(rows) + QLatin1Char('\n') + exampleLine(command.example);
}

}  // namespace

QString helpText(const CommandSpec* command) {
    return command == nullptr ? overview() : commandHelp(*command);
}

QString versionText() {
    return QStringLiteral("kickstand-sim " KICKSTAND_VERSION "\n");
}

}  // namespace kickstand::sim
