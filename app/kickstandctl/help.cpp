#include "app/kickstandctl/help.h"

#include <algorithm>

#include "app/kickstandctl/command.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

QString translated(const char* text) {
    return *text == '\0' ? QString() : QCoreApplication::translate("kickstandctl", text);
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

QString globalOptions() {
    return columns({
        {QStringLiteral("--link URI"),
         Words::tr("usb:, usb:?port=1-2.3, usb-cable:, usbip:127.0.0.1:3240/1-1, "
                   "serial:/dev/rfcomm0?protocol=motionplan, sim:motionplan or "
                   "sim:thunderbots?robots=0-15&loss=0.02; "
                   "without it the only hardware that is found")},
        {QStringLiteral("--json"), Words::tr("one JSON value; a value a line where it streams")},
        {QStringLiteral("--help"), Words::tr("this; after a command, help on that command")},
        {QStringLiteral("--version"), Words::tr("which version this is")},
    });
}

QString commandList(std::string_view group) {
    QList<QPair<QString, QString>> rows;
    for (const CommandSpec& command : commands()) {
        const std::string_view name(command.name);
        if (!group.empty() && !name.starts_with(group)) continue;
        rows.append({QString::fromUtf8(command.name), translated(command.summary)});
    }
    return columns(rows);
}

QString overview(std::string_view group) {
    QString text = Words::tr("kickstandctl: drive, tune and watch small robots from the command line.") +
                   QStringLiteral("\n\n");
    text += Words::tr("Usage: kickstandctl [--link URI] [--json] COMMAND …") + QStringLiteral("\n\n");
    text += Words::tr("Commands:") + QLatin1Char('\n') + commandList(group) + QLatin1Char('\n');
    text += Words::tr("For all of them:") + QLatin1Char('\n') + globalOptions() + QLatin1Char('\n');
    text += Words::tr("Example: %1")
                .arg(QStringLiteral("kickstandctl --link sim:thunderbots thunderbots status")) +
            QLatin1Char('\n');
    text += Words::tr(
                "Whatever ends a command, a signal too, leaves the robots braked. Exit: 0 done, 1 the robot "
                "or link "
                "refused or failed, 2 bad usage.") +
            QLatin1Char('\n');
    return text;
}

QString usageLine(const CommandSpec& command) {
    QString line = QStringLiteral("kickstandctl ") + QString::fromUtf8(command.name);
    for (const OptionSpec& option : command.options) {
        QString one = QString::fromUtf8(option.name);
        if (*option.value != '\0') one += QLatin1Char(' ') + QString::fromUtf8(option.value);
        line += option.required ? QLatin1Char(' ') + one : QStringLiteral(" [%1]").arg(one);
    }
    if (*command.operands != '\0') line += QLatin1Char(' ') + QString::fromUtf8(command.operands);
    return line;
}

QString commandHelp(const CommandSpec& command) {
    QString text = Words::tr("Usage: %1").arg(usageLine(command)) + QStringLiteral("\n\n");
    text += translated(command.summary) + QLatin1Char('\n');
    if (*command.details != '\0') text += translated(command.details) + QLatin1Char('\n');
    if (!command.options.empty()) {
        QList<QPair<QString, QString>> rows;
        for (const OptionSpec& option : command.options) {
            QString name = QString::fromUtf8(option.name);
            if (*option.value != '\0') name += QLatin1Char(' ') + QString::fromUtf8(option.value);
            rows.append({name, translated(option.help)});
        }
        text += QLatin1Char('\n') + Words::tr("Options:") + QLatin1Char('\n') + columns(rows);
    }
    if (command.list != nullptr) text += QLatin1Char('\n') + command.list();
    text += QLatin1Char('\n') + Words::tr("For all commands:") + QLatin1Char('\n') + globalOptions();
    text +=
        QLatin1Char('\n') +
        Words::tr("Example: %1").arg(QStringLiteral("kickstandctl ") + QString::fromUtf8(command.example)) +
        QLatin1Char('\n');
    return text;
}

}  // namespace

QString helpText(std::string_view name) {
    for (const CommandSpec& command : commands()) {
        if (name == command.name) return commandHelp(command);
    }
    return overview(name);
}

QString versionText() {
    return QStringLiteral("kickstandctl " KICKSTAND_VERSION "\n");
}

}  // namespace kickstand::ctl
