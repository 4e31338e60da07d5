#include "core/engine/describe.h"

#include <QCoreApplication>

#include "core/engine/describe_error_texts.h"
#include "core/engine/describe_facts.h"

namespace kickstand {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("Error", text);
}

}  // namespace

QString Description::line() const {
    QString whole = what;
    for (const QString& part : {remedy, remedyCommand}) {
        if (part.isEmpty()) continue;
        if (!whole.isEmpty()) whole += QLatin1Char(' ');
        whole += part;
    }
    return whole;
}

Description describe(const Error& error) {
    Description description;
    for (const ErrorText& text : errorTexts()) {
        if (text.code != error.code) continue;
        if (*text.onlyFor != '\0' && text.onlyFor != error.subject) continue;
        const auto what = fillFacts(translated(text.what), error);
        const auto remedy = *text.remedy == '\0' ? QString() : fillFacts(translated(text.remedy), error);
        if (!what || !remedy) continue;
        description.what = *what;
        description.remedy = *remedy;
        description.remedyCommand = QString::fromUtf8(text.remedyCommand);
        return description;
    }
    // A code that came from another version of the program.
    description.what =
        QCoreApplication::translate("Error", "Something failed that this program has no words for.");
    return description;
}

}  // namespace kickstand
