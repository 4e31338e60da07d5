#include "ui/shell/events_panel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCollator>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QTableView>
#include <algorithm>
#include <numeric>

#include "ui/shell/bench.h"
#include "ui/shell/system_view.h"
#include "ui/widgets/save_file.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kRowHeight = 24;
constexpr int kTimeWidth = 108;
/// Room for "robot 15", and for what longer names may take.
constexpr int kAboutWidth = 76;
constexpr int kMostAboutWidth = 200;
constexpr int kMostUnits = 128;
constexpr double kMark = 8;
/// Room for "explain".
constexpr int kMore = 72;

/// Draws a line of the list: what is bad has a shape beside its colour.
class EventDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Tokens& t = tokensOf(option.palette);
        painter->save();
        if (option.state.testFlag(QStyle::State_Selected)) painter->fillRect(option.rect, t.accentSoft);
        painter->fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), t.grid);
        QRect area = option.rect.adjusted(metrics::kPadding, 0, -4, 0);
        painter->setPen(index.column() == EventModel::Time ? t.muted : t.text);
        const auto severity = static_cast<Severity>(index.data(EventModel::SeverityRole).toInt());
        if (index.column() == EventModel::Text && severity != Severity::Information) {
            const Tone tone = severity == Severity::Danger ? Tone::Danger : Tone::Warning;
            drawTone(*painter, tone, QRectF(area.left(), area.center().y() - kMark / 2 + 1, kMark, kMark),
                     toneColour(tone, t));
            area.setLeft(area.left() + static_cast<int>(kMark) + 6);
            painter->setPen(toneColour(tone, t));
        }
        const QString text = index.data().toString();
        painter->setFont(option.font);
        const QString shown = option.fontMetrics.elidedText(
            text, Qt::ElideRight, area.width() - (index.column() == EventModel::Text ? kMore : 0));
        painter->drawText(area, Qt::AlignVCenter | Qt::TextSingleLine, shown);
        if (index.column() == EventModel::Text && !index.data(EventModel::PlaceRole).toString().isEmpty()) {
            area.setLeft(area.left() + option.fontMetrics.horizontalAdvance(shown) + metrics::kGap);
            painter->setPen(t.accent);
            painter->drawText(area, Qt::AlignVCenter | Qt::TextSingleLine, EventsPanel::tr("explain \u203a"));
        }
        painter->restore();
    }
};

}  // namespace

EventsPanel::EventsPanel(Bench& bench, QWidget* parent)
    : Panel(bench, parent), view_(new QTableView(this)), empty_(new QLabel(this)) {
    filter_.setSourceModel(&model_);
    buildView();
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
    // One over the other, inside the panel's rounded frame.
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(1, 0, 1, metrics::kPanelRadius);
    layout->addWidget(view_, 0, 0);
    layout->addWidget(empty_, 0, 0);

    connect(&bench.client(), &EngineClient::eventsArrived, this, &EventsPanel::take);
    connect(&bench.client(), &EngineClient::refused, this, &EventsPanel::takeRefusal);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
        connect(&filter_, signal, this, &EventsPanel::refreshEmpty);
    }
    refreshEmpty();
}

void EventsPanel::buildView() {
    view_->setObjectName(QStringLiteral("eventList"));
    view_->setAccessibleName(tr("Events, newest first"));
    view_->setModel(&filter_);
    view_->setItemDelegate(new EventDelegate(view_));
    view_->setFrameShape(QFrame::NoFrame);
    view_->setShowGrid(false);
    view_->setWordWrap(false);
    view_->setFont(numberFont(metrics::kTextSize));
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->setTabKeyNavigation(false);
    view_->horizontalHeader()->hide();
    view_->horizontalHeader()->setStretchLastSection(true);
    view_->verticalHeader()->hide();
    view_->verticalHeader()->setMinimumSectionSize(kRowHeight);
    view_->verticalHeader()->setDefaultSectionSize(kRowHeight);
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view_->setColumnWidth(EventModel::Time, kTimeWidth);
    view_->setColumnWidth(EventModel::Robot, kAboutWidth);

    addActions();
    connect(view_->verticalScrollBar(), &QScrollBar::valueChanged, this, &EventsPanel::noteScroll);
    connect(&filter_, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int first, int last) {
                if (first == 0) keepPlace(first, last);
            });
}

void EventsPanel::addActions() {
    const auto add = [this](const QString& text, const QKeySequence& keys, auto act) {
        auto* action = new QAction(text, view_);
        action->setShortcut(keys);
        action->setShortcutContext(Qt::WidgetShortcut);
        connect(action, &QAction::triggered, this, act);
        view_->addAction(action);
        return action;
    };
    add(tr("Copy"), QKeySequence::Copy, &EventsPanel::copySelection);
    QAction* explain = add(tr("Explain"), QKeySequence(Qt::Key_Return), [this] { explainCurrent(); });
    explain->setShortcuts({QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)});
    add(tr("Save all that is shown\u2026"), QKeySequence::Save, &EventsPanel::save);
    view_->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(view_, &QTableView::doubleClicked, this, &EventsPanel::explainCurrent);
    const auto refresh = [this, explain] { explain->setEnabled(!placeOfCurrent().isEmpty()); };
    connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, refresh);
    refresh();
}

QWidget* EventsPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    addFilters(tools, row);
    addButtons(tools, row);
    return tools;
}

void EventsPanel::addFilters(QWidget* tools, QHBoxLayout* row) {
    auto* text = new QLineEdit(tools);
    text->setObjectName(QStringLiteral("eventText"));
    text->setPlaceholderText(tr("Filter"));
    text->setAccessibleName(tr("Show events that contain"));
    text->setClearButtonEnabled(true);
    text->setFixedWidth(150);
    units_ = new QComboBox(tools);
    units_->setObjectName(QStringLiteral("eventRobot"));
    units_->setAccessibleName(tr("Show events of the source"));
    units_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    units_->addItem(tr("All sources"), QString());
    for (const QString& about : std::as_const(known_))
        units_->addItem(about, about);
    auto* least = new QComboBox(tools);
    least->setObjectName(QStringLiteral("eventSeverity"));
    least->setAccessibleName(tr("Show events from this weight on"));
    least->addItem(tr("Everything"), static_cast<int>(Severity::Information));
    least->addItem(tr("Warnings"), static_cast<int>(Severity::Warning));
    least->addItem(tr("Dangers"), static_cast<int>(Severity::Danger));
    row->addWidget(text);
    row->addWidget(units_);
    row->addWidget(least);
    connect(text, &QLineEdit::textChanged, &filter_, &EventFilter::setText);
    connect(units_, &QComboBox::currentIndexChanged, this,
            [this] { filter_.setAbout(units_->currentData().toString()); });
    connect(least, &QComboBox::currentIndexChanged, this,
            [this, least] { filter_.setLeast(static_cast<Severity>(least->currentData().toInt())); });
}

void EventsPanel::addButtons(QWidget* tools, QHBoxLayout* row) {
    const auto add = [tools, row](const QString& text, const char* name, const QString& tip) {
        auto* button = new QPushButton(text, tools);
        button->setObjectName(QString::fromLatin1(name));
        button->setAutoDefault(false);
        button->setToolTip(tip);
        button->setFixedHeight(metrics::kFieldHeight);
        row->addWidget(button);
        return button;
    };
    follow_ = add(tr("Follow"), "eventFollow", tr("Keeps the newest in view. Scrolling down lets go of it."));
    follow_->setCheckable(true);
    follow_->setChecked(true);
    connect(follow_, &QPushButton::toggled, this, [this](bool on) {
        if (on) view_->scrollToTop();
    });
    connect(add(tr("Copy"), "eventCopy", tr("Copies the lines that are marked, or all that are shown.")),
            &QPushButton::clicked, this, &EventsPanel::copySelection);
    connect(add(tr("Save\u2026"), "eventSave", tr("Writes all that is shown to a CSV file.")),
            &QPushButton::clicked, this, &EventsPanel::save);
}

void EventsPanel::take(const std::vector<EngineEvent>& events, quint64 lost) {
    std::vector<EventLine> lines;
    lines.reserve(events.size() + 1);
    if (lost > 0) {
        EventLine line;
        line.time = std::chrono::system_clock::now();
        line.text = tr("%n event(s) came too fast to be kept", nullptr, static_cast<int>(lost));
        line.severity = Severity::Warning;
        lines.push_back(std::move(line));
    }
    for (const EngineEvent& event : events) {
        EventText words = describe(event);
        EventLine line;
        line.time = bench().client().wallTime(timeOf(event));
        line.robot = robotOf(event);
        line.about = aboutOf(event);
        line.text = std::move(words.text);
        line.severity = words.severity;
        line.place = placeOf(event);
        know(line.about);
        lines.push_back(std::move(line));
    }
    model_.add(std::move(lines));
    if (model_.dropped() > 0) setNote(tr("the oldest %1 gave way").arg(model_.dropped()));
}

void EventsPanel::takeRefusal(const Error& error) {
    EventLine line;
    line.time = std::chrono::system_clock::now();
    line.robot = error.robot.value_or(-1);
    if (line.robot >= 0) line.about = tr("robot %1").arg(line.robot);
    line.text = tr("Refused: %1").arg(describe(error).line());
    line.severity = Severity::Warning;
    line.countable = true;
    know(line.about);
    model_.add({std::move(line)});
}

void EventsPanel::know(const QString& about) {
    if (about.isEmpty() || known_.contains(about) || known_.size() >= kMostUnits) return;
    QCollator order;
    order.setNumericMode(true);
    const auto place = std::lower_bound(known_.begin(), known_.end(), about, order);
    const auto at = static_cast<int>(place - known_.begin());
    known_.insert(at, about);
    if (units_ != nullptr) units_->insertItem(at + 1, about, about);
    const int wanted = view_->fontMetrics().horizontalAdvance(about) + 2 * metrics::kPadding;
    if (wanted > view_->columnWidth(EventModel::Robot))
        view_->setColumnWidth(EventModel::Robot, std::min(wanted, kMostAboutWidth));
}

QString EventsPanel::placeOf(const EngineEvent& event) const {
    const auto* body = std::get_if<SystemEvent>(&event.body);
    const SessionSnapshot* session = body == nullptr ? nullptr : bench().client().session(event.session);
    const SystemView* view = session == nullptr ? nullptr : bench().systems().viewOf(session->system);
    return view == nullptr ? QString() : view->placeOf(*body);
}

QString EventsPanel::placeOfCurrent() const {
    return view_->currentIndex().siblingAtColumn(EventModel::Text).data(EventModel::PlaceRole).toString();
}

void EventsPanel::explainCurrent() {
    const QString place = placeOfCurrent();
    if (!place.isEmpty()) bench().goTo(place);
}

void EventsPanel::copySelection() {
    std::vector<int> rows;
    for (const QModelIndex& row : view_->selectionModel()->selectedRows())
        rows.push_back(row.row());
    if (rows.empty()) {
        rows.resize(static_cast<std::size_t>(filter_.rowCount()));
        std::iota(rows.begin(), rows.end(), 0);
    }
    std::sort(rows.begin(), rows.end());
    if (!rows.empty()) QApplication::clipboard()->setText(eventText(filter_, rows));
}

void EventsPanel::save() {
    askToSave(this, tr("Save events"), QStringLiteral("kickstand-events.csv"), QStringLiteral("csv"),
              [this] { return eventCsv(filter_); });
}

void EventsPanel::keepPlace(int first, int last) {
    QScrollBar* bar = view_->verticalScrollBar();
    const bool follows = follow_ == nullptr || follow_->isChecked();
    // What is being read stays where it is while newer lines come in above it.
    const int top = follows ? 0 : bar->value() + (last - first + 1) * kRowHeight;
    placing_ = true;
    view_->doItemsLayout();
    bar->setValue(top);
    placing_ = false;
}

void EventsPanel::noteScroll(int value) {
    if (!placing_ && follow_ != nullptr) follow_->setChecked(value == 0);
}

void EventsPanel::refreshEmpty() {
    empty_->setVisible(filter_.rowCount() == 0);
    empty_->setText(model_.rowCount() == 0 ? tr("Nothing has happened yet.")
                                           : tr("Nothing that happened passes the filter."));
}

void EventsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) view_->viewport()->update();
    Panel::changeEvent(event);
}

}  // namespace kickstand::ui
