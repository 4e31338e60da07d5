#include "ui/thunderbots/parameters_grid.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "core/engine/describe_parameters.h"
#include "ui/thunderbots/parameters_field.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

enum Column { kTick, kField, kRobot, kMark, kDraft, kTake, kOther };
constexpr int kDraftWidth = 148;
constexpr int kValueWidth = 98;

QString named(const char* kind, ParameterField field) {
    const std::string_view text = name(field);
    return QString::fromLatin1(kind) + QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setFont(textFont(metrics::kSmallTextSize, QFont::DemiBold));
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QLabel* valueLabel(const QString& name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setFont(numberFont(metrics::kTextSize));
    label->setMinimumWidth(kValueWidth);
    return label;
}

void showMark(QLabel& mark, bool changed) {
    const QString text = changed ? QStringLiteral("\u25b2") : QString();
    if (mark.text() == text) return;
    mark.setText(text);
    mark.setToolTip(changed ? ParametersGrid::tr("Differs from the robot") : QString());
}

QString valueText(ParameterField field, const std::optional<std::uint8_t>& value) {
    return value ? describeValue(field, *value) : QStringLiteral("\u2013");
}

}  // namespace

ParametersGrid::ParametersGrid(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kGap);
    grid->setVerticalSpacing(2);
    addHeader(grid);
    for (const ParameterField field : kParameterFields)
        addRow(grid, field);
    grid->setColumnStretch(kOther, 1);
    colourMarks();
}

void ParametersGrid::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colourMarks();
}

void ParametersGrid::colourMarks() {
    QPalette own = palette();
    own.setColor(QPalette::WindowText, tokensOf(own).warn);
    for (const Row& row : rows_)
        row.mark->setPalette(own);
}

void ParametersGrid::addHeader(QGridLayout* grid) {
    grid->addWidget(heading(tr("Apply"), this), 0, kTick, 1, 2);
    grid->addWidget(heading(tr("Robot"), this), 0, kRobot);
    grid->addWidget(heading(tr("Draft"), this), 0, kDraft);
    otherTitle_ = heading(tr("File"), this);
    otherTitle_->setObjectName(QStringLiteral("otherTitle"));
    otherTitle_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    grid->addWidget(otherTitle_, 0, kOther);
    takeAll_ = new QToolButton(this);
    takeAll_->setObjectName(QStringLiteral("parameterTakeAll"));
    takeAll_->setText(tr("\u2190 all"));
    takeAll_->setToolTip(tr("Takes the third column over into the draft, but for the flash contents."));
    connect(takeAll_, &QToolButton::clicked, this, &ParametersGrid::takeAllAsked);
    grid->addWidget(takeAll_, 0, kTake);
}

void ParametersGrid::addRow(QGridLayout* grid, ParameterField field) {
    const int line = static_cast<int>(field) + 1;
    Row& made = row(field);
    made.tick = new QCheckBox(this);
    made.tick->setAccessibleName(tr("Apply %1").arg(describe(field)));
    made.name = new QLabel(describe(field), this);
    made.tick->setObjectName(named("apply_", field));
    made.tick->setToolTip(tr("Whether this change is applied."));
    made.robot = valueLabel(named("robot_", field), this);
    made.mark = new QLabel(this);
    made.mark->setObjectName(named("mark_", field));
    made.mark->setFixedWidth(12);
    made.draft = new ParametersField(field, this);
    made.draft->setFixedWidth(kDraftWidth);
    made.take = new QToolButton(this);
    made.take->setObjectName(named("take_", field));
    made.take->setText(QStringLiteral("\u2190"));
    made.take->setAccessibleName(tr("Take %1 over from the file").arg(describe(field)));
    made.take->setToolTip(tr("Takes this value over into the draft."));
    made.other = valueLabel(named("other_", field), this);
    grid->addWidget(made.tick, line, kTick);
    grid->addWidget(made.name, line, kField);
    grid->addWidget(made.robot, line, kRobot);
    grid->addWidget(made.mark, line, kMark);
    grid->addWidget(made.draft, line, kDraft);
    grid->addWidget(made.take, line, kTake);
    grid->addWidget(made.other, line, kOther);
    connect(made.draft, &ParametersField::asked, this,
            [this, field](std::uint8_t value, bool goesOn) { emit edited(field, value, goesOn); });
    connect(made.take, &QToolButton::clicked, this, [this, field] { emit takeAsked(field); });
    connect(made.tick, &QCheckBox::toggled, this, &ParametersGrid::ticksChanged);
}

void ParametersGrid::showValues(const ParameterDraft& draft, const ParameterValues& other,
                                const QString& otherTitle, bool editable) {
    const ParameterMask before = std::exchange(changes_, draft.changes());
    otherTitle_->setText(otherTitle);
    otherTitle_->setToolTip(otherTitle);
    takeAll_->setEnabled(editable && other != ParameterValues{});
    for (const ParameterField field : kParameterFields) {
        const bool changed = contains(changes_, field);
        const QSignalBlocker blocker(row(field).tick);
        if (changed != contains(before, field)) row(field).tick->setChecked(changed);
        row(field).tick->setEnabled(changed);
        showRow(field, draft, other, editable);
    }
}

void ParametersGrid::showRow(ParameterField field, const ParameterDraft& draft, const ParameterValues& other,
                             bool editable) {
    const Row& shown = row(field);
    const auto robot = draft.robot() ? std::optional(valueOf(*draft.robot(), field)) : std::nullopt;
    const auto& fromOther = other[static_cast<std::size_t>(field)];
    const bool changed = contains(changes_, field);
    shown.name->setFont(textFont(metrics::kTextSize, changed ? QFont::DemiBold : QFont::Normal));
    shown.robot->setText(valueText(field, robot));
    showMark(*shown.mark, changed);
    shown.draft->showValue(draft.value(field));
    shown.draft->setEnabled(editable);
    const bool differs = fromOther && fromOther != draft.value(field);
    shown.other->setText(valueText(field, fromOther));
    shown.other->setFont(numberFont(metrics::kTextSize, differs ? QFont::Bold : QFont::Normal));
    shown.other->setToolTip(differs ? tr("Differs from the draft") : QString());
    shown.take->setEnabled(editable && differs);
}

ParameterMask ParametersGrid::ticked() const {
    ParameterMask mask = 0;
    for (const ParameterField field : kParameterFields) {
        if (contains(changes_, field) && rows_[static_cast<std::size_t>(field)].tick->isChecked())
            mask = static_cast<ParameterMask>(mask | maskOf(field));
    }
    return mask;
}

}  // namespace kickstand::ui
