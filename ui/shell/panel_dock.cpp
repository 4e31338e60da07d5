#include "ui/shell/panel_dock.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollArea>
#include <utility>

#include "ui/shell/panel.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kHeaderHeight = 36;
constexpr int kHeaderFontSize = 12;
/// What there is for a panel in the middle of the smallest screen, 1280 × 800, under a title bar.
constexpr int kMostLeastWidth = 600;
constexpr int kMostLeastHeight = 232;

/// A dock takes its title's height from the size hint alone.
class PanelHeader final : public QWidget {
  public:
    using QWidget::QWidget;
    QSize sizeHint() const override { return {QWidget::sizeHint().width(), kHeaderHeight}; }
    QSize minimumSizeHint() const override { return {0, kHeaderHeight}; }
};

/// Gives a panel the least room that it asks for, up to a bound: one that wants more can be scrolled, and
/// never pushes the others aside.
class PanelScroll final : public QScrollArea {
  public:
    explicit PanelScroll(QWidget* parent) : QScrollArea(parent) {
        setFrameShape(QFrame::NoFrame);
        setWidgetResizable(true);
        setFocusPolicy(Qt::NoFocus);
    }
    QSize sizeHint() const override { return widget() == nullptr ? QSize() : widget()->sizeHint(); }
    QSize minimumSizeHint() const override {
        if (widget() == nullptr) return {};
        const QSize least = widget()->minimumSizeHint().expandedTo(widget()->minimumSize());
        return least.boundedTo({kMostLeastWidth, kMostLeastHeight});
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

}  // namespace

PanelDock::PanelDock(const QString& id, const QString& title, const QString& helpPage,
                     std::function<Panel*()> make, QWidget* parent)
    : QDockWidget(title, parent), make_(std::move(make)), helpPage_(helpPage) {
    setObjectName(id);
    setAccessibleName(title);
    // A click beside its controls says as well which panel is meant.
    setFocusPolicy(Qt::ClickFocus);
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
    auto* scroll = new PanelScroll(this);
    scroll->setWidget(panel_);
    scroll->viewport()->setAutoFillBackground(false);
    panel_->setAutoFillBackground(false);
    setWidget(scroll);
    // The layout of docks takes from a dock's own hint when there is too little for all.
    setMinimumWidth(scroll->minimumSizeHint().width());
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
