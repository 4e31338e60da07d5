#include "ui/smartdevice/device_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <utility>

#include "core/engine/describe.h"
#include "core/smartdevice/commands.h"
#include "ui/shell/bench.h"
#include "ui/smartdevice/device_choice.h"
#include "ui/smartdevice/device_words.h"
#include "ui/smartdevice/parameter_row.h"
#include "ui/smartdevice/smartdevice_view.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

constexpr int kNameSize = 16;
/// What the field of a dialect holds.
constexpr int kLongestDelay_ms = 255;
constexpr int kLongestHibikeDelay_ms = 65535;
constexpr int kFirstDelay_ms = 40;

QLabel* small(const char* name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setFont(textFont(metrics::kSmallTextSize));
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}  // namespace

DevicePanel::DevicePanel(Bench& bench, DeviceChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      empty_(new QLabel(tr("No board is there yet. Each one is shown here as it is found."), this)),
      body_(new QWidget(this)),
      name_(new QLineEdit(body_)),
      kind_(small("boardKind", body_)),
      standing_(new StateLabel(body_)),
      disable_(new QPushButton(tr("Disable"), body_)),
      delay_(new QSpinBox(body_)),
      read_(new QPushButton(tr("Read all once"), body_)),
      granted_(small("boardGranted", body_)),
      blocked_(new Banner(Banner::Kind::Warning, body_)),
      notice_(new QLabel(body_)),
      tablePlace_(new QWidget(body_)) {
    build();
    connectHead();
    connect(&bench, &Bench::changed, this, &DevicePanel::refresh);
    connect(&choice_, &DeviceChoice::changed, this, &DevicePanel::refresh);
    refresh();
}

void DevicePanel::build() {
    empty_->setObjectName(QStringLiteral("boardEmpty"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setWordWrap(true);
    blocked_->setObjectName(QStringLiteral("boardBlocked"));
    blocked_->setText(tr("Stopped."), tr("Nothing is written until you re-arm."));
    notice_->setObjectName(QStringLiteral("boardNotice"));
    notice_->setWordWrap(true);
    notice_->setTextFormat(Qt::PlainText);
    auto* column = new QVBoxLayout(body_);
    column->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    column->setSpacing(metrics::kGap);
    column->addWidget(makeHead());
    column->addWidget(makeUpdates());
    column->addWidget(blocked_);
    column->addWidget(notice_);
    column->addWidget(tablePlace_);
    column->addStretch(1);
    auto* place = new QVBoxLayout(tablePlace_);
    place->setContentsMargins(0, 0, 0, 0);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(empty_);
    all->addWidget(body_);
}

QWidget* DevicePanel::makeHead() {
    auto* head = new QWidget(body_);
    auto* grid = new QGridLayout(head);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kPadding);
    grid->setVerticalSpacing(2);
    name_->setObjectName(QStringLiteral("boardName"));
    name_->setAccessibleName(tr("Name of the board"));
    name_->setToolTip(tr("What you call it; kept with its UID, wherever it is plugged in"));
    name_->setFont(textFont(kNameSize, QFont::DemiBold));
    name_->setFixedWidth(240);
    standing_->setObjectName(QStringLiteral("boardStanding"));
    disable_->setObjectName(QStringLiteral("boardDisable"));
    disable_->setToolTip(tr("The board stops everything. The next value that is written lets it go on."));
    disable_->setAutoDefault(false);
    kind_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(name_, 0, 0);
    grid->addWidget(standing_, 0, 1);
    grid->addWidget(disable_, 0, 2);
    grid->addWidget(kind_, 1, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    return head;
}

QWidget* DevicePanel::makeUpdates() {
    auto* box = new QWidget(body_);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    delay_->setObjectName(QStringLiteral("boardDelay"));
    delay_->setAccessibleName(tr("Time between two updates"));
    delay_->setToolTip(
        tr("How often the board is asked to send the checked parameters; 0 for never. The board "
           "may grant another time."));
    delay_->setRange(0, kLongestDelay_ms);
    delay_->setValue(kFirstDelay_ms);
    delay_->setSuffix(tr(" ms"));
    delay_->setSpecialValueText(tr("never"));
    delay_->setKeyboardTracking(false);
    auto* label = new QLabel(tr("Updates every"), box);
    label->setBuddy(delay_);
    read_->setObjectName(QStringLiteral("boardRead"));
    read_->setToolTip(tr("Asks for every parameter that can be read"));
    read_->setAutoDefault(false);
    row->addWidget(label);
    row->addWidget(delay_);
    row->addWidget(granted_, 1);
    row->addWidget(read_);
    return box;
}

void DevicePanel::connectHead() {
    connect(name_, &QLineEdit::editingFinished, this, &DevicePanel::nameEdited);
    connect(delay_, &QSpinBox::valueChanged, this, [this](int delay_ms) {
        if (const DeviceState* one = device()) subscribe(one->wanted, delay_ms);
    });
    connect(read_, &QPushButton::clicked, this, [this] {
        const DeviceState* one = device();
        if (one == nullptr) return;
        bench().submit(smartdevice::Command(ReadValues{one->number, one->spec->readable()}), this,
                       [this](const Result<void>& result) {
                           notice_->setText(result ? QString() : describe(result.error()).line());
                       });
    });
    connect(disable_, &QPushButton::clicked, this, [this] {
        const DeviceState* one = device();
        if (one != nullptr) bench().submit(smartdevice::Command(DisableDevice{one->number}));
    });
}

const Snapshot* DevicePanel::snapshot() const {
    return boardsOf(bench().session());
}

const DeviceState* DevicePanel::device() const {
    return choice_.deviceOf(snapshot());
}

void DevicePanel::closed() {
    const Snapshot* const now = snapshot();
    if (now == nullptr) return;
    for (const DeviceState& one : now->devices) {
        // What is on its way may drive, too.
        const bool asked = one.number == shown_ && !waiting_.empty();
        if (one.driving || asked) bench().submit(smartdevice::Command(DisableDevice{one.number}));
    }
    for (auto& [parameter, next] : waiting_)
        next.reset();
}

// ---- What is asked for.

void DevicePanel::nameEdited() {
    const DeviceState* one = device();
    if (one == nullptr) return;
    const QString kind = QString::fromStdString(one->spec->name);
    setOwnName(bench().settings(), *one, name_->text() == kind ? QString() : name_->text());
    emit choice_.changed();
}

void DevicePanel::subscribe(wire::ParameterMask mask, int delay_ms) {
    const DeviceState* one = device();
    if (one == nullptr) return;
    bench().submit(smartdevice::Command(Subscribe{one->number, mask, static_cast<std::uint16_t>(delay_ms)}),
                   this, [this](const Result<void>& result) {
                       notice_->setText(result ? QString() : describe(result.error()).line());
                   });
}

void DevicePanel::write(int parameter, const wire::Value& value) {
    // A slider asks faster than a board answers: only the newest waits.
    if (const auto busy = waiting_.find(parameter); busy != waiting_.end())
        busy->second = value;
    else
        submitWrite(parameter, value);
}

void DevicePanel::submitWrite(int parameter, const wire::Value& value) {
    waiting_[parameter].reset();
    bench().submit(smartdevice::Command(WriteValues{shown_, {{parameter, value}}}), this,
                   [this, device = shown_, parameter](const Result<void>& result) {
                       written(device, parameter, result);
                   });
}

void DevicePanel::written(int device, int parameter, const Result<void>& result) {
    if (device != shown_) return;
    const auto next = waiting_.extract(parameter);
    if (!result) {
        // What waited is dropped: after a refusal nothing goes out that nobody asks for again.
        if (result.error().code == Errc::DeviceRefused)
            notice_->setText(describe(result.error()).line());
        else
            showFailure(parameter, result.error());
    } else {
        notice_->clear();
        if (next && next.mapped() && !bench().client().isStopped()) submitWrite(parameter, *next.mapped());
    }
    refresh();
}

void DevicePanel::showFailure(int parameter, const Error& error) {
    notice_->setText(describe(error).line());
    if (static_cast<std::size_t>(parameter) < rows_.size())
        rows_[static_cast<std::size_t>(parameter)]->showFailure(error);
}

// ---- What is shown.

void DevicePanel::rebuild(const DeviceState& device) {
    shown_ = device.number;
    uid_ = device.uid;
    spec_ = device.spec;
    rows_.clear();
    waiting_.clear();
    notice_->clear();
    delete std::exchange(table_, new QWidget(tablePlace_));
    tablePlace_->layout()->addWidget(table_);
    auto* grid = new QGridLayout(table_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kPadding);
    grid->setVerticalSpacing(2);
    const std::pair<int, QString> heads[] = {{ParameterRow::Update, tr("Sent")},
                                             {ParameterRow::Name, tr("Parameter")},
                                             {ParameterRow::Value, tr("Value")},
                                             {ParameterRow::Editor, tr("Set")},
                                             {ParameterRow::Verdict, tr("Last write")}};
    for (const auto& [column, text] : heads) {
        auto* head = small("", table_);
        head->setText(text);
        if (column == ParameterRow::Value) head->setAlignment(Qt::AlignRight);
        grid->addWidget(head, 0, column);
    }
    for (std::size_t i = 0; i < spec_->parameters.size(); ++i) {
        auto* row = new ParameterRow(spec_->parameters[i], static_cast<int>(i), *grid, table_);
        rows_.push_back(row);
        connect(row, &ParameterRow::writeAsked, this, &DevicePanel::write);
        connect(row, &ParameterRow::refused, this,
                [this, i](const Error& error) { showFailure(static_cast<int>(i), error); });
        connect(row, &ParameterRow::updateAsked, this, [this](int parameter, bool on) {
            const DeviceState* one = this->device();
            if (one == nullptr) return;
            const auto bit = static_cast<wire::ParameterMask>(1U << parameter);
            const int delay_ms = delay_->value() == 0 ? kFirstDelay_ms : delay_->value();
            subscribe(static_cast<wire::ParameterMask>(on ? one->wanted | bit : one->wanted & ~bit),
                      delay_ms);
        });
    }
    grid->setColumnMinimumWidth(ParameterRow::Value, 112);
    grid->setColumnMinimumWidth(ParameterRow::Verdict, 128);
    grid->setColumnStretch(ParameterRow::Editor, 1);
}

void DevicePanel::refresh() {
    const Snapshot* const now = snapshot();
    const DeviceState* const one = device();
    empty_->setVisible(one == nullptr);
    body_->setVisible(one != nullptr);
    if (one == nullptr) {
        shown_ = -1;
        spec_.reset();
        setNote({});
        return;
    }
    // A number may have been given to another board, also of the same kind.
    if (one->number != shown_ || one->uid != uid_ || one->spec != spec_) rebuild(*one);
    refreshHead(*one);
    blocked_->setVisible(now->blocked);
    if (now->blocked) waiting_.clear();
    notice_->setVisible(!notice_->text().isEmpty());
    for (std::size_t i = 0; i < rows_.size(); ++i)
        rows_[i]->refresh(*one, bench().client().now(), now->blocked, waiting_.contains(static_cast<int>(i)));
}

void DevicePanel::refreshHead(const DeviceState& device) {
    const QString title = titleOf(bench().settings(), device);
    if (!name_->hasFocus() && name_->text() != title) name_->setText(title);
    const Standing standing = standingOf(device, bench().client().now());
    standing_->setState(standing.tone, standing.text);
    QString kind = tr("%1 \u00b7 %2 \u00b7 UID %3")
                       .arg(QString::fromStdString(device.spec->name), QString::fromStdString(device.port),
                            QString::fromStdString(wire::toText(device.uid)));
    if (device.latency) kind += tr(" \u00b7 answers in %1, %2").arg(medianText(device), p99Text(device));
    if (kind_->text() != kind) kind_->setText(kind);
    kind_->setToolTip(QString::fromStdString(device.spec->note));
    const bool there = device.presence != Presence::Lost;
    disable_->setEnabled(there);
    read_->setEnabled(there && device.spec->readable() != 0);
    delay_->setEnabled(there);
    if (!delay_->hasFocus()) {
        const QSignalBlocker quiet(delay_);
        const bool hibike = device.uid.dialect == wire::Dialect::Hibike;
        delay_->setMaximum(hibike ? kLongestHibikeDelay_ms : kLongestDelay_ms);
        delay_->setValue(device.wantedDelay_ms);
    }
    const QString granted = updatesText(device);
    if (granted_->text() != granted) granted_->setText(granted);
    setNote(title);
}

}  // namespace kickstand::ui
