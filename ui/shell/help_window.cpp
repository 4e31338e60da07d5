#include "ui/shell/help_window.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextList>
#include <QTextTable>
#include <QVBoxLayout>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kParagraphGap = 8;
constexpr int kHeadingGap = 18;
constexpr int kCellPadding = 6;

/// As forges make a heading's anchor: "Why does it not work?" is "why-does-it-not-work".
QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber()) anchor += c;
        if (c.isSpace() || c == u'-') anchor += u'-';
    }
    return anchor;
}

/// Gives a page that was read from Markdown the room that it has in print.
void setOut(QTextDocument& page, const Tokens& tokens) {
    QTextCursor cursor(&page);
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
        cursor.setPosition(block.position());
        if (cursor.currentTable() != nullptr) continue;
        QTextBlockFormat format = block.blockFormat();
        if (format.headingLevel() > 0) format.setTopMargin(kHeadingGap);
        format.setBottomMargin(block.textList() == nullptr ? kParagraphGap : kParagraphGap / 2.0);
        cursor.setBlockFormat(format);
    }
    for (QTextFrame* frame : page.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        QTextTableFormat format = table->format();
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(tokens.line);
        format.setCellPadding(kCellPadding);
        format.setBottomMargin(kHeadingGap - kParagraphGap);
        table->setFormat(format);
        for (int cell = 0; cell < table->rows() * table->columns(); ++cell) {
            QTextTableCell here = table->cellAt(cell / table->columns(), cell % table->columns());
            QTextTableCellFormat lines = here.format().toTableCellFormat();
            lines.setBorderBrush(tokens.line);
            here.setFormat(lines);
        }
    }
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QWidget(parent, Qt::Window), browser_(new QTextBrowser(this)) {
    setObjectName(QStringLiteral("help"));
    setWindowTitle(tr("Kickstand help"));
    resize(820, 720);
    browser_->setAccessibleName(tr("Help"));
    browser_->setOpenExternalLinks(true);
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->document()->setDocumentMargin(2 * metrics::kPadding);
    auto* back = new QPushButton(tr("&Back"), this);
    auto* contents = new QPushButton(tr("&Contents"), this);
    back->setEnabled(false);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, 0);
    row->addWidget(back);
    row->addWidget(contents);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(browser_, 1);
    connect(browser_, &QTextBrowser::sourceChanged, this,
            [this] { setOut(*browser_->document(), tokensOf(palette())); });
    connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
    connect(browser_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(contents, &QPushButton::clicked, this, [this] { showPage(QStringLiteral("index.md")); });
}

void HelpWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) setOut(*browser_->document(), tokensOf(palette()));
    QWidget::changeEvent(event);
}

void HelpWindow::showHeading(const QString& anchor) {
    if (anchor.isEmpty()) return;
    for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || anchorOf(block.text()) != anchor) continue;
        // To the end first, so that going back to the heading brings it to the top.
        browser_->moveCursor(QTextCursor::End);
        browser_->setTextCursor(QTextCursor(block));
        return;
    }
}

void HelpWindow::showPage(const QString& page) {
    const QUrl url(QStringLiteral("qrc:/help/") + page);
    browser_->setSource(url.adjusted(QUrl::RemoveFragment), QTextDocument::MarkdownResource);
    // Only what is laid out can be scrolled to.
    show();
    showHeading(url.fragment());
    raise();
    activateWindow();
}

}  // namespace kickstand::ui
