#include "ui/thunderbots/checks_report_file.h"

#include <QAction>
#include <QBuffer>
#include <QCoreApplication>
#include <QJsonDocument>
#include <QMenu>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QTextDocument>

#include "ui/widgets/save_file.h"

namespace kickstand::ui {

using thunderbots::CheckProgress;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ChecksReport)
};

using Made = std::function<QByteArray()>;

QByteArray pdf(const QString& html) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setPageSize(QPageSize(QPageSize::A4));
        QTextDocument document;
        document.setHtml(html);
        document.print(&writer);
    }
    return buffer.data();
}

/// Qt's own dialog, so that STOP keys reach the program while it is open; where a system has nothing but its
/// own, a PDF is what can be printed.
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
void print(QWidget* parent, const QString& html) {
    auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    auto* dialog = new QPrintDialog(printer.get(), parent);
    dialog->setObjectName(QStringLiteral("printDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), parent, [html](QPrinter* chosen) {
        QTextDocument document;
        document.setHtml(html);
        document.print(chosen);
    });
    // It lasts as long as the dialog that works on it.
    QObject::connect(dialog, &QObject::destroyed, parent, [printer] {});
    dialog->open();
}
#endif

}  // namespace

void addReportActions(QMenu* menu, QWidget* parent,
                      const std::function<std::shared_ptr<const CheckProgress>()>& current,
                      const std::function<WallTime(TimePoint)>& wallTime) {
    const auto html = [current, wallTime] {
        const auto check = current();
        return checkReportHtml(*check, wallTime(check->began));
    };
    const auto add = [menu, parent](const char* suffix, const QString& text, const Made& made) {
        QAction* action = menu->addAction(text);
        action->setObjectName(QStringLiteral("checksSave_%1").arg(QLatin1String(suffix)));
        QObject::connect(action, &QAction::triggered, parent, [parent, suffix, made] {
            askToSave(parent, Words::tr("Save report"), QStringLiteral("check.%1").arg(QLatin1String(suffix)),
                      QLatin1String(suffix), made);
        });
    };
    add("html", Words::tr("As a page (HTML)\u2026"), [html] { return html().toUtf8(); });
    add("pdf", Words::tr("As PDF\u2026"), [html] { return pdf(html()); });
    add("json", Words::tr("As JSON\u2026"), [current, wallTime] {
        const auto check = current();
        return QJsonDocument(checkReport(*check, wallTime(check->began))).toJson();
    });
    add("txt", Words::tr("As text\u2026"), [current, wallTime] {
        const auto check = current();
        return checkReportText(*check, wallTime(check->began)).toUtf8();
    });
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    menu->addSeparator();
    QAction* paper = menu->addAction(Words::tr("Print\u2026"));
    paper->setObjectName(QStringLiteral("checksPrint"));
    QObject::connect(paper, &QAction::triggered, parent, [parent, html] { print(parent, html()); });
#endif
}

}  // namespace kickstand::ui
