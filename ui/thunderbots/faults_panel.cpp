#include "ui/thunderbots/faults_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "core/thunderbots/events.h"
#include "ui/shell/bench.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr const char* kDonglePlace = "dongle-";
constexpr int kRowHeight = 24;
constexpr int kSearchWidth = 180;
constexpr int kTableWidth = 64;
constexpr int kCodeWidth = 84;
constexpr int kAboutWidth = 128;
constexpr int kMeaningWidth = 264;

/// The line that is marked is tinted quietly, as in the list of events.
class FaultDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        const Tokens& t = tokensOf(option->palette);
        option->palette.setColor(QPalette::Highlight, t.accentSoft);
        option->palette.setColor(QPalette::HighlightedText, t.text);
    }
};

}  // namespace

FaultsPanel::FaultsPanel(Bench& bench, QWidget* parent) : Panel(bench, parent), view_(new QTableView(this)) {
    tables_.setSourceModel(&model_);
    tables_.setFilterKeyColumn(FaultsModel::Table);
    filter_.setSourceModel(&tables_);
    filter_.setFilterRole(FaultsModel::kSearchRole);
    filter_.setFilterCaseSensitivity(Qt::CaseInsensitive);
    buildView();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 0, 1, metrics::kPanelRadius);
    layout->addWidget(view_);
    connect(&bench.client(), &EngineClient::eventsArrived, this, &FaultsPanel::noteEvents);
}

void FaultsPanel::buildView() {
    view_->setObjectName(QStringLiteral("faultList"));
    view_->setAccessibleName(tr("Fault codes"));
    view_->setModel(&filter_);
    view_->setItemDelegate(new FaultDelegate(view_));
    view_->setFrameShape(QFrame::NoFrame);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setFont(numberFont(metrics::kTextSize));
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->setTabKeyNavigation(false);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setMinimumSectionSize(kRowHeight);
    view_->verticalHeader()->setDefaultSectionSize(kRowHeight);
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    QHeaderView* header = view_->horizontalHeader();
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setHighlightSections(false);
    header->setStretchLastSection(true);
    view_->setColumnWidth(FaultsModel::Table, kTableWidth);
    view_->setColumnWidth(FaultsModel::Code, kCodeWidth);
    view_->setColumnWidth(FaultsModel::About, kAboutWidth);
    view_->setColumnWidth(FaultsModel::Meaning, kMeaningWidth);
}

QWidget* FaultsPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    search_ = new QLineEdit(tools);
    search_->setObjectName(QStringLiteral("faultSearch"));
    search_->setPlaceholderText(tr("Search: 41, radio 1, encoder"));
    search_->setAccessibleName(tr("Search the fault codes"));
    search_->setClearButtonEnabled(true);
    search_->setFixedWidth(kSearchWidth);
    table_ = new QComboBox(tools);
    table_->setObjectName(QStringLiteral("faultTable"));
    table_->setAccessibleName(tr("Which table"));
    table_->addItem(tr("Both tables"), QString());
    table_->addItem(tr("Dongle"), tr("Dongle"));
    table_->addItem(tr("Robot"), tr("Robot"));
    table_->setItemData(2, tr("No pipe carries these yet: they serve for looking up."), Qt::ToolTipRole);
    row->addWidget(search_);
    row->addWidget(table_);
    connect(search_, &QLineEdit::textChanged, this,
            [this](const QString& text) { filter_.setFilterFixedString(text.simplified()); });
    connect(table_, &QComboBox::currentIndexChanged, this,
            [this] { tables_.setFilterFixedString(table_->currentData().toString()); });
    return tools;
}

QString FaultsPanel::placeOf(std::uint8_t dongleCode) {
    return QStringLiteral("faults#%1%2").arg(QLatin1String(kDonglePlace)).arg(dongleCode);
}

void FaultsPanel::showDetail(const QString& detail) {
    if (!detail.startsWith(QLatin1String(kDonglePlace))) return;
    const int row = model_.rowOf(FaultTable::Dongle, detail.mid(QLatin1String(kDonglePlace).size()).toInt());
    if (search_ != nullptr) search_->clear();
    if (table_ != nullptr) table_->setCurrentIndex(0);
    const QModelIndex index = filter_.mapFromSource(tables_.mapFromSource(model_.index(row, 0)));
    view_->setCurrentIndex(index);
    view_->scrollTo(index, QAbstractItemView::PositionAtCenter);
    view_->setFocus(Qt::OtherFocusReason);
}

void FaultsPanel::noteEvents(const std::vector<EngineEvent>& events) {
    for (const EngineEvent& event : events) {
        const auto* system = std::get_if<SystemEvent>(&event.body);
        const auto* own = system == nullptr ? nullptr : std::get_if<Event>(system);
        if (own == nullptr || own->kind != EventKind::DongleFault) continue;
        if (own->code >= 0 && own->code <= UINT8_MAX) model_.noteSeen(static_cast<std::uint8_t>(own->code));
    }
    if (model_.unknownSeen() > 0) setNote(tr("codes in no table: %1").arg(model_.unknownSeen()));
}

}  // namespace kickstand::ui
