#include "ui/shell/remedy_text.h"

#include <QCoreApplication>

#include "core/engine/describe.h"

namespace kickstand::ui {

namespace {

struct RemedyText {
    Q_DECLARE_TR_FUNCTIONS(RemedyText)
};

}  // namespace

QString remedyBesideCopy(const Description& words) {
    // A remedy that leads up to its command ends in a colon.
    if (words.remedyCommand.isEmpty() || !words.remedy.endsWith(u':')) return words.remedy;
    return RemedyText::tr("%1 copy the command.").arg(words.remedy);
}

}  // namespace kickstand::ui
