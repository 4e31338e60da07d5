#include "ui/thunderbots/flash_page.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/widgets/scrolled.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kRowGap = 2;
/// Two rows are better than a page whose buttons have to be scrolled to.
constexpr int kLeastHeight = 56;
/// So that the scroll bar does not cover what stands at the right end.
constexpr int kScrollBarRoom = 12;

QVBoxLayout* flatColumn(QWidget* parent) {
    auto* column = parent == nullptr ? new QVBoxLayout : new QVBoxLayout(parent);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kRowGap);
    return column;
}

}  // namespace

FlashPageView::FlashPageView(QWidget* parent)
    : QWidget(parent),
      content_(new QWidget),
      scroll_(scrolled(content_, this)),
      head_(flatColumn(nullptr)),
      column_(flatColumn(content_)),
      foot_(flatColumn(nullptr)) {
    column_->setContentsMargins(0, 0, kScrollBarRoom, 0);
    scroll_->setMinimumHeight(kLeastHeight);
    auto* all = flatColumn(this);
    all->setSpacing(metrics::kGap);
    all->addLayout(head_);
    all->addWidget(scroll_, 1);
    all->addLayout(foot_);
}

void FlashPageView::reveal(QWidget* part) const {
    scroll_->ensureWidgetVisible(part, 0, 0);
}

QLabel* FlashPageView::makeText(const char* name, QWidget* parent) const {
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

QPushButton* FlashPageView::makeButton(const char* name, const QString& text, QWidget* parent) const {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    return button;
}

}  // namespace kickstand::ui
