#include "ui/plot/plot_tools.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>
#include <array>
#include <chrono>

#include "ui/plot/time_plot.h"
#include "ui/plot/time_ticks.h"
#include "ui/widgets/segmented.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

constexpr std::array kSpans_s{1, 5, 10, 30, 60, 120, 300, 600, 1800, 3600};

QString spanText(int span_s) {
    if (span_s < 120) return PlotTools::tr("%1 s").arg(span_s);
    if (span_s < 3600) return PlotTools::tr("%1 min").arg(span_s / 60);
    return PlotTools::tr("%1 h").arg(span_s / 3600);
}

}  // namespace

PlotTools::PlotTools(TimePlot& plot, const QString& name, QWidget* parent)
    : QWidget(parent),
      plot_(plot),
      running_(new Segmented({tr("Pause"), tr("Follow")}, this)),
      span_(makeSpan(name)),
      cursors_(new QPushButton(tr("Cursors"), this)) {
    running_->button(0)->setObjectName(name + QStringLiteral("Pause"));
    running_->button(0)->setToolTip(tr("Stands still; recording goes on (P)"));
    running_->button(1)->setObjectName(name + QStringLiteral("Follow"));
    running_->button(1)->setToolTip(tr("Goes along with the present (F, or double-click)"));
    cursors_->setObjectName(name + QStringLiteral("Cursors"));
    cursors_->setCheckable(true);
    cursors_->setAutoDefault(false);
    cursors_->setToolTip(
        tr("Two cursors and what lies between them (C; Shift+arrows move one, X takes the other)"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(running_);
    row->addWidget(span_);
    row->addWidget(cursors_);
    connect(running_, &Segmented::asked, &plot_,
            [this](int index) { index == 0 ? plot_.pause() : plot_.follow(); });
    connect(cursors_, &QPushButton::clicked, &plot_, &TimePlot::showCursors);
    connect(&plot_, &TimePlot::viewChanged, this, &PlotTools::refresh);
    refresh();
}

QPushButton* PlotTools::makeSpan(const QString& name) {
    auto* button = new QPushButton(this);
    auto* menu = new QMenu(this);
    menu->setObjectName(name + QStringLiteral("SpanMenu"));
    menu->addSection(tr("Time"));
    for (const int span_s : kSpans_s) {
        menu->addAction(spanText(span_s), this, [this, span_s] {
            plot_.setSpan(std::chrono::seconds(span_s));
            emit spanChosen(span_s);
        });
    }
    menu->addAction(tr("From the &oldest\tHome"), &plot_, &TimePlot::showOldest);
    menu->addSection(tr("Values"));
    menu->addAction(tr("&Fit what is seen\tV"), &plot_, &TimePlot::fitValues);
    menu->addAction(tr("&Usual range\tU"), &plot_, &TimePlot::usualValues);
    button->setObjectName(name + QStringLiteral("Span"));
    button->setAutoDefault(false);
    button->setMenu(menu);
    button->setAccessibleName(tr("Span of time that is shown"));
    button->setToolTip(tr("Wheel, + and \u2212 zoom time; with Ctrl they zoom values"));
    return button;
}

void PlotTools::refresh() {
    running_->setCurrent(plot_.isFollowing() ? 1 : 0);
    const Duration span = plot_.state().view.span();
    const auto span_s = std::chrono::round<std::chrono::seconds>(span);
    span_->setText(span_s >= 1s ? spanText(static_cast<int>(span_s.count())) : durationText(span));
    cursors_->setChecked(plot_.state().cursors.isShown());
}

}  // namespace kickstand::ui
