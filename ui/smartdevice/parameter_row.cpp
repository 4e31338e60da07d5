#include "ui/smartdevice/parameter_row.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "core/engine/describe.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

constexpr int kRowHeight = 32;

QString hintOf(const ParameterSpec& spec) {
    QString hint = ParameterRow::tr("%1, %2").arg(QString::fromStdString(spec.name),
                                                  QString::fromLatin1(wire::name(spec.type)));
    if (spec.lowest && spec.highest)
        hint += ParameterRow::tr(", %1 to %2").arg(*spec.lowest).arg(*spec.highest);
    else if (spec.lowest)
        hint += ParameterRow::tr(", from %1").arg(*spec.lowest);
    else if (spec.highest)
        hint += ParameterRow::tr(", up to %1").arg(*spec.highest);
    if (!spec.note.empty()) hint += QStringLiteral("\n") + QString::fromStdString(spec.note);
    if (spec.zeroOnStop) hint += ParameterRow::tr("\nSTOP writes zero to it.");
    return hint;
}

QLabel* mutedLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setEnabled(false);
    return label;
}

}  // namespace

ParameterRow::ParameterRow(const ParameterSpec& spec, int number, QGridLayout& grid, QWidget* table)
    : QObject(table),
      spec_(spec),
      number_(number),
      update_(new QCheckBox(table)),
      name_(new QLabel(QString::fromStdString(spec.name), table)),
      value_(new QLabel(table)),
      verdict_(new StateLabel(table)) {
    const int line = number + 1;
    const QString text = name_->text();
    update_->setObjectName(QStringLiteral("update%1").arg(number));
    update_->setAccessibleName(tr("%1 is sent by itself").arg(text));
    update_->setToolTip(tr("Whether the board sends %1 again and again").arg(text));
    update_->setVisible(spec_.readable());
    verdict_->setObjectName(QStringLiteral("verdict%1").arg(number));
    grid.setRowMinimumHeight(line, kRowHeight);
    grid.addWidget(update_, line, Update, Qt::AlignCenter);
    makeName(grid, table);
    makeValue(grid, table);
    makeEditor(grid, table);
    grid.addWidget(verdict_, line, Verdict);
    connect(update_, &QCheckBox::clicked, this, [this](bool on) { emit updateAsked(number_, on); });
}

void ParameterRow::makeName(QGridLayout& grid, QWidget* table) {
    name_->setToolTip(hintOf(spec_));
    name_->setTextFormat(Qt::PlainText);
    if (spec_.readable()) {
        grid.addWidget(name_, number_ + 1, Name);
        return;
    }
    auto* mark = mutedLabel(tr("write only"), table);
    mark->setObjectName(QStringLiteral("mark%1").arg(number_));
    auto* both = new QHBoxLayout;
    both->setSpacing(metrics::kGap);
    both->addWidget(name_);
    both->addWidget(mark);
    both->addStretch();
    grid.addLayout(both, number_ + 1, Name);
}

void ParameterRow::makeValue(QGridLayout& grid, QWidget* table) {
    Q_UNUSED(table)
    value_->setObjectName(QStringLiteral("value%1").arg(number_));
    value_->setFont(numberFont(metrics::kTextSize, QFont::DemiBold));
    value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value_->setTextFormat(Qt::PlainText);
    grid.addWidget(value_, number_ + 1, Value);
}

void ParameterRow::makeEditor(QGridLayout& grid, QWidget* table) {
    if (!spec_.writable()) {
        grid.addWidget(mutedLabel(tr("read only"), table), number_ + 1, Editor);
        return;
    }
    editor_ = makeParameterEditor(spec_, name_->text(), table);
    editor_->setObjectName(QStringLiteral("editor%1").arg(number_));
    grid.addWidget(editor_, number_ + 1, Editor);
    connect(editor_, &ParameterEditor::asked, this, [this](const wire::Value& value) {
        failure_.reset();
        emit writeAsked(number_, value);
    });
    connect(editor_, &ParameterEditor::refused, this, &ParameterRow::refused);
}

void ParameterRow::showFailure(const Error& error) {
    failure_ = standingOf(error);
    verdict_->setToolTip(describe(error).line());
}

void ParameterRow::refresh(const DeviceState& device, TimePoint now, bool blocked, bool waiting) {
    const ParameterState& state = device.parameters[static_cast<std::size_t>(number_)];
    const bool wanted = (device.wanted >> number_ & 1U) != 0 && device.wantedDelay_ms != 0;
    update_->setChecked(wanted);
    update_->setEnabled(device.presence != Presence::Lost);
    QString text;
    bool old = false;
    if (!spec_.readable()) {
        old = true;
        text = state.written ? tr("set to %1").arg(withUnit(valueText(*state.written, spec_), spec_))
                             : QStringLiteral("\u2014");
    } else if (!state.value) {
        old = true;
        text = QStringLiteral("\u2014");
    } else {
        text = withUnit(valueText(*state.value, spec_), spec_);
        old = isOld(state, device, now);
        if (old) text += tr(", %1").arg(agoText(now - state.at));
    }
    if (value_->text() != text) value_->setText(text);
    value_->setForegroundRole(old ? QPalette::PlaceholderText : QPalette::WindowText);
    const Standing standing = failure_  ? *failure_
                              : waiting ? Standing{Tone::Busy, tr("pending")}
                                        : standingOf(state, spec_);
    verdict_->setVisible(!standing.text.isEmpty());
    verdict_->setState(standing.tone, standing.text);
    if (!failure_) verdict_->setToolTip({});
    if (editor_ == nullptr) return;
    editor_->setEnabled(!blocked && device.presence != Presence::Lost && !device.learning);
    const bool own = state.verdict == WriteVerdict::Pending || !spec_.readable();
    if (!waiting) editor_->showValue(own ? state.written : state.value);
}

}  // namespace kickstand::ui
