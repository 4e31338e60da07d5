#include "ui/shell/panel_dock.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <utility>

#include "ui/shell/panel.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kHeaderHeight = 36;
constexpr int kHeaderFontSize = 12;

/// A dock takes its title's height from the size hint alone.
class PanelHeader final : public QWidget {
  public:
    using QWidget::QWidget;
    QSize sizeHint() const override { return {QWidget::sizeHint().width(), kHeaderHeight}; }
    QSize minimumSizeHint() const override { return {0, kHeaderHeight}; }
};

}  // namespace

PanelDock::PanelDock(const QString& id, const QString& title, const QString& helpPage,
                     std::function<Panel*()> make, QWidget* parent)
    : QDockWidget(title, parent), make_(std::move(make)), helpPage_(helpPage) {
    setObjectName(id);
    setAccessibleName(title);
    auto* header = new PanelHeader(this);
    headerRow_ = new QHBoxLayout(header);
    headerRow_->setContentsMargins(metrics::kPadding, 1, metrics::kGap, 1);
    headerRow_->setSpacing(metrics::kGap);
    auto* name = new QLabel(title, header);
    name->setFont(textFont(kHeaderFontSize, QFont::DemiBold));
    headerRow_->addWidget(name);
    headerRow_->addStretch(1);
    setTitleBarWidget(header);
}

Panel* PanelDock::panel() {
    if (panel_ == nullptr) makePanel();
    return panel_;
}

void PanelDock::makePanel() {
    panel_ = make_();
    if (QWidget* tools = panel_->headerTools()) headerRow_->addWidget(tools);
    auto* note = new QLabel(panel_->note(), titleBarWidget());
    note->setObjectName(QStringLiteral("note"));
    note->setFont(numberFont(kHeaderFontSize));
    note->setForegroundRole(QPalette::PlaceholderText);
    note->setContentsMargins(0, 0, metrics::kGap / 2, 0);
    headerRow_->addWidget(note);
    note->setVisible(!panel_->note().isEmpty());
    connect(panel_, &Panel::noteChanged, note, [note](const QString& text) {
        note->setText(text);
        note->setVisible(!text.isEmpty());
    });
    setWidget(panel_);
}

void PanelDock::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Tokens& t = tokensOf(palette());
    painter.setPen(QPen(t.line, 1));
    painter.setBrush(t.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kPanelRadius,
                            metrics::kPanelRadius);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(QRect(1, kHeaderHeight - 1, width() - 2, 1), t.line);
}

void PanelDock::closeEvent(QCloseEvent* event) {
    if (panel_ != nullptr) panel_->closed();
    QDockWidget::closeEvent(event);
}

}  // namespace kickstand::ui
