#include "ui/shell/doctor_window.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

#include "core/engine/describe_findings.h"
#include "ui/shell/bench.h"
#include "ui/shell/doctor_row.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

constexpr QSize kFirstSize(800, 560);
constexpr int kVerdictSize = 15;
/// Devices are looked for again this often while no link of theirs runs.
constexpr auto kLookInterval = 2s;

}  // namespace

DoctorWindow::DoctorWindow(Bench& bench, QWidget* parent)
    : QWidget(parent, Qt::Window), bench_(bench), verdict_(new StateLabel(this)), list_(new QVBoxLayout) {
    setObjectName(QStringLiteral("doctor"));
    setWindowTitle(tr("Why does it not work?"));
    resize(kFirstSize);
    verdict_->setObjectName(QStringLiteral("verdict"));
    verdict_->setFont(textFont(kVerdictSize, QFont::DemiBold));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    column->setSpacing(metrics::kPadding);
    column->addWidget(verdict_);
    column->addWidget(makeList(), 1);
    column->addWidget(makeButtons());
    connect(&bench_, &Bench::changed, this, &DoctorWindow::refresh);
    connect(&bench_.client(), &EngineClient::stopChanged, this, &DoctorWindow::refresh);
    connect(&look_, &QTimer::timeout, this, &DoctorWindow::lookAgain);
}

QWidget* DoctorWindow::makeList() {
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setAccessibleName(tr("What was looked at"));
    auto* surface = new QWidget(area);
    surface->setBackgroundRole(QPalette::Base);
    surface->setAutoFillBackground(true);
    auto* column = new QVBoxLayout(surface);
    column->setContentsMargins(0, 0, 0, 0);
    list_->setSpacing(0);
    column->addLayout(list_);
    column->addStretch(1);
    area->setWidget(surface);
    return area;
}

QWidget* DoctorWindow::makeButtons() {
    auto* buttons = new QWidget(this);
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    auto* copy = new QPushButton(tr("Copy all"), buttons);
    copy->setObjectName(QStringLiteral("copyReport"));
    copy->setToolTip(tr("All lines as text, to send to somebody who can help."));
    auto* help = new QPushButton(tr("Help"), buttons);
    auto* close = new QPushButton(tr("Close"), buttons);
    for (QPushButton* button : {copy, help, close})
        button->setAutoDefault(false);
    row->addWidget(copy);
    row->addWidget(help);
    row->addStretch(1);
    row->addWidget(close);
    connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(report()); });
    connect(help, &QPushButton::clicked, this, &DoctorWindow::helpAsked);
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    return buttons;
}

void DoctorWindow::showEvent(QShowEvent* event) {
    lookAgain();
    look_.start(kLookInterval);
    refresh();
    QWidget::showEvent(event);
}

void DoctorWindow::hideEvent(QHideEvent* event) {
    look_.stop();
    QWidget::hideEvent(event);
}

void DoctorWindow::lookAgain() {
    const SessionSnapshot* session = bench_.session();
    // What is simulated needs no device; without a session the connector looks by itself.
    if (session != nullptr && !session->uri.isSimulated()) bench_.client().submit(0, Discover{});
}

void DoctorWindow::refresh() {
    if (!look_.isActive()) return;
    findings_ = diagnose(bench_.client().snapshot(), bench_.session());
    while (rows_.size() > findings_.size()) {
        rows_.back()->deleteLater();
        rows_.pop_back();
    }
    while (rows_.size() < findings_.size()) {
        rows_.push_back(new DoctorRow(this));
        list_->addWidget(rows_.back());
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
        rows_[i]->showFinding(findings_[i]);
    const auto wrong = std::find_if(findings_.begin(), findings_.end(), [](const Finding& finding) {
        return finding.state == CheckState::Problem;
    });
    const auto toLookAt = std::count_if(findings_.begin(), findings_.end(), [](const Finding& finding) {
        return finding.state == CheckState::Warning;
    });
    if (wrong != findings_.end()) {
        verdict_->setState(Tone::Danger, tr("Begin here: %1").arg(describe(*wrong).what));
    } else if (toLookAt > 0) {
        verdict_->setState(Tone::Warning, tr("Nothing is broken. To look at: %1.").arg(toLookAt));
    } else {
        verdict_->setState(Tone::Good, tr("Nothing that was looked at is wrong."));
    }
}

QString DoctorWindow::report() const {
    QStringList lines;
    for (const Finding& finding : findings_) {
        lines << QStringLiteral("%1  %2  %3")
                     .arg(describe(finding.state).leftJustified(8), describe(finding.check).leftJustified(15),
                          describe(finding).line());
    }
    return lines.join(u'\n');
}

}  // namespace kickstand::ui
