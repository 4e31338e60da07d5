#include "ui/thunderbots/flash_files_page.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/engine/describe_images.h"
#include "ui/thunderbots/flash_words.h"
#include "ui/widgets/open_file.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;
using image::FlashTarget;

namespace {

constexpr int kTargetWidth = 150;

/// The surface that a file stands on.
class FileCard final : public QWidget {
  public:
    using QWidget::QWidget;

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(tokensOf(palette()).line);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kControlRadius,
                                metrics::kControlRadius);
    }
};

QStringList localFiles(const QMimeData* data) {
    QStringList paths;
    for (const QUrl& url : data->urls()) {
        if (url.isLocalFile()) paths << url.toLocalFile();
    }
    return paths;
}

}  // namespace

FlashFilesPage::FlashFilesPage(QWidget* parent) : FlashPageView(parent) {
    setAcceptDrops(true);
    auto* row = new QHBoxLayout;
    auto* words = makeText("flashFilesWords", this);
    words->setText(tr("Which firmware? One file, or one for each chip. Drop them here, or choose them."));
    choose_ = makeButton("flashChoose", tr("Choose files\u2026"), this);
    row->addWidget(words, 1);
    row->addWidget(choose_);
    head()->addLayout(row);
    connect(choose_, &QPushButton::clicked, this, &FlashFilesPage::ask);
    empty_ = makeText("flashNoFile", content());
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setText(tr("No file yet. Intel HEX, raw binary and Xilinx .bit are read, up to 8 MiB."));
    column()->addWidget(empty_);
    for (std::size_t file = 0; file < cards_.size(); ++file)
        cards_[file] = makeCard(file);
    order_ = makeText("flashOrder", content());
    addFpga_ = makeButton("flashAddFpga", tr("Add the FPGA's file\u2026"), content());
    notice_ = makeText("flashFilesNotice", content());
    column()->addWidget(order_);
    column()->addWidget(addFpga_, 0, Qt::AlignLeft);
    column()->addWidget(notice_);
    column()->addStretch(1);
    connect(addFpga_, &QPushButton::clicked, this, &FlashFilesPage::ask);
}

FlashFilesPage::Card FlashFilesPage::makeCard(std::size_t file) {
    Card card;
    card.all = new FileCard(content());
    auto* lines = new QVBoxLayout(card.all);
    lines->setContentsMargins(metrics::kGap, 6, metrics::kGap, 6);
    lines->setSpacing(4);
    lines->addWidget(makeCardHead(card, file));
    const QString place = QString::number(file);
    card.facts = makeText("flashFacts", card.all);
    card.facts->setObjectName(QStringLiteral("flashFacts") + place);
    card.facts->setFont(textFont(metrics::kSmallTextSize));
    card.problem = makeText("flashProblem", card.all);
    card.problem->setObjectName(QStringLiteral("flashProblem") + place);
    card.verdict = new StateLabel(card.all);
    lines->addWidget(card.facts);
    lines->addWidget(card.verdict);
    lines->addWidget(card.problem);
    column()->addWidget(card.all);
    return card;
}

QWidget* FlashFilesPage::makeCardHead(Card& card, std::size_t file) {
    auto* box = new QWidget(card.all);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    const QString place = QString::number(file);
    card.name = new QLabel(box);
    card.name->setObjectName(QStringLiteral("flashFile") + place);
    card.name->setTextFormat(Qt::PlainText);
    card.name->setFont(textFont(metrics::kTextSize, QFont::DemiBold));
    // A long name is cut rather than widening the panel; the whole of it is one hover away.
    card.name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    card.target = new QComboBox(box);
    card.target->setObjectName(QStringLiteral("flashTarget") + place);
    card.target->setAccessibleName(tr("Which chip file %1 is for").arg(file + 1));
    card.target->addItem(tr("Microcontroller"), static_cast<int>(FlashTarget::Microcontroller));
    card.target->addItem(tr("FPGA"), static_cast<int>(FlashTarget::Fpga));
    card.target->setFixedWidth(kTargetWidth);
    card.why = new QLabel(box);
    card.why->setObjectName(QStringLiteral("flashWhy") + place);
    card.why->setFont(textFont(metrics::kSmallTextSize));
    card.why->setForegroundRole(QPalette::PlaceholderText);
    card.why->setWordWrap(true);
    auto* remove = makeButton("flashRemove", tr("Remove"), box);
    remove->setObjectName(QStringLiteral("flashRemove") + place);
    row->addWidget(card.name, 2);
    row->addWidget(card.target);
    row->addWidget(card.why, 3);
    row->addWidget(remove);
    connect(remove, &QPushButton::clicked, this, [this, file] { emit removeAsked(file); });
    connect(card.target, &QComboBox::activated, this, [this, file, target = card.target] {
        emit targetAsked(file, static_cast<FlashTarget>(target->currentData().toInt()));
    });
    return box;
}

void FlashFilesPage::ask() {
    askToOpen(this, tr("Choose firmware"),
              {tr("Firmware (*.hex *.ihx *.mcs *.bin *.bit)"), tr("All files (*)")},
              [this](const QStringList& paths) { emit pathsAsked(paths); });
}

void FlashFilesPage::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void FlashFilesPage::dropEvent(QDropEvent* event) {
    const QStringList paths = localFiles(event->mimeData());
    if (paths.isEmpty()) return;
    event->acceptProposedAction();
    emit pathsAsked(paths);
}

void FlashFilesPage::showState(const FlashWizardState& state, const QString& notice) {
    empty_->setVisible(state.files.empty() && state.reading == 0);
    for (std::size_t file = 0; file < cards_.size(); ++file) {
        cards_[file].all->setVisible(file < state.files.size());
        if (file < state.files.size()) showCard(cards_[file], state.files[file]);
    }
    const QString order = filesNotice(state);
    order_->setText(order);
    order_->setVisible(!order.isEmpty());
    addFpga_->setVisible(state.losesBitstream());
    const QString text = state.reading > 0 ? tr("Reading\u2026") : notice;
    notice_->setText(text);
    notice_->setVisible(!text.isEmpty());
}

void FlashFilesPage::showCard(const Card& card, const FlashFile& file) {
    card.name->setText(file.name);
    card.name->setToolTip(file.path);
    const QString problem = fileProblem(file);
    card.target->setVisible(file.isImage());
    card.target->setCurrentIndex(card.target->findData(static_cast<int>(file.target)));
    card.why->setVisible(file.isImage());
    card.why->setText(file.target == file.guess.target ? tr("guessed: %1").arg(describe(file.guess.reason))
                                                       : tr("chosen by hand"));
    const QString facts = fileFacts(file).join(u'\n');
    card.facts->setText(facts);
    card.facts->setVisible(!facts.isEmpty());
    card.problem->setText(problem);
    card.problem->setVisible(!problem.isEmpty());
    card.verdict->setState(problem.isEmpty() ? Tone::Good : Tone::Danger,
                           problem.isEmpty() ? tr("can be sent") : tr("refused"));
}

}  // namespace kickstand::ui
