#include "ui/thunderbots/drive_keys_box.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QTextEdit>
#include <chrono>

#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

constexpr const char* kLettersSetting = "drive/keys";
constexpr const char* kSpeedSetting = "drive/keySpeed_percent";
constexpr int kFirstSpeed_percent = 40;
constexpr int kCapWidth = 40;
constexpr int kSpeedWidth = 56;
/// How soon after it a lost release is noticed.
constexpr auto kWatch = 50ms;

TimePoint now() {
    return TimePoint(std::chrono::steady_clock::now().time_since_epoch());
}

/// Whether letters mean something to the widget that has the focus.
bool takesLetters(const QWidget* focus) {
    if (const auto* line = qobject_cast<const QLineEdit*>(focus))
        return qobject_cast<const QAbstractSpinBox*>(line->parentWidget()) == nullptr;
    return qobject_cast<const QTextEdit*>(focus) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(focus) != nullptr ||
           qobject_cast<const QComboBox*>(focus) != nullptr ||
           qobject_cast<const QAbstractItemView*>(focus) != nullptr;
}

QString meaningOf(DriveKey key) {
    switch (key) {
        case DriveKey::Forward:
            return DriveKeysBox::tr("Forward");
        case DriveKey::Back:
            return DriveKeysBox::tr("Back");
        case DriveKey::Left:
            return DriveKeysBox::tr("To the left");
        case DriveKey::Right:
            return DriveKeysBox::tr("To the right");
        case DriveKey::TurnLeft:
            return DriveKeysBox::tr("Turn left");
        case DriveKey::TurnRight:
            return DriveKeysBox::tr("Turn right");
    }
    return {};
}

}  // namespace

DriveKeysBox::DriveKeysBox(QSettings& settings, QWidget* parent)
    : QWidget(parent),
      settings_(settings),
      on_(new QPushButton(tr("Drive by keys"), this)),
      speed_(new SignedSpinBox(this)) {
    map_.setLetters(settings.value(kLettersSetting).toString().toStdString());
    on_->setObjectName(QStringLiteral("driveByKeys"));
    on_->setCheckable(true);
    on_->setAutoDefault(false);
    on_->setToolTip(tr("While this is on, the letters beside it drive for as long as they are held."));
    speed_->setObjectName(QStringLiteral("keySpeed"));
    speed_->setRange(1, 100);
    speed_->setValue(settings.value(kSpeedSetting, kFirstSpeed_percent).toInt());
    speed_->setFixedWidth(kSpeedWidth);
    speed_->setAccessibleName(tr("How fast keys drive, in percent of the limit"));
    speed_->setToolTip(tr("How fast keys drive, in percent of the limit"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    row->addWidget(on_);
    row->addWidget(makeCaps());
    row->addStretch(1);
    row->addWidget(new QLabel(tr("at"), this));
    row->addWidget(speed_);
    row->addWidget(new QLabel(tr("%"), this));
    connect(on_, &QPushButton::toggled, this, [this] {
        letGo();
        showCaps();
    });
    connect(speed_, &QSpinBox::valueChanged, this, [this](int percent) {
        settings_.setValue(kSpeedSetting, percent);
        if (held_.any()) tell();
    });
    connect(&watch_, &QTimer::timeout, this, [this] {
        if (!held_.expire(now())) return;
        tell();
        emit noticed(tr("The key is not repeated any more: zero. Press it again."));
    });
    connect(qApp, &QApplication::focusChanged, this, &DriveKeysBox::focusMoved);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive) letGo();
    });
    qApp->installEventFilter(this);
    setUsable(false);
}

QWidget* DriveKeysBox::makeCaps() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (const DriveKey key : kDriveKeys) {
        auto* cap = new QPushButton(box);
        cap->setObjectName(QStringLiteral("driveKey%1").arg(static_cast<int>(key) + 1));
        cap->setFixedWidth(kCapWidth);
        cap->setCheckable(true);
        cap->setAutoDefault(false);
        connect(cap, &QPushButton::clicked, this,
                [this, key] { setLearning(learning_ == key ? std::optional<DriveKey>() : key); });
        caps_[static_cast<std::size_t>(key)] = cap;
        row->addWidget(cap);
    }
    showCaps();
    return box;
}

void DriveKeysBox::setUsable(bool usable) {
    if (usable == usable_) return;
    usable_ = usable;
    on_->setEnabled(usable);
    speed_->setEnabled(usable);
    if (!usable) letGo();
}

void DriveKeysBox::letGo() {
    if (!held_.any()) return;
    held_.letGo();
    tell();
}

void DriveKeysBox::setLearning(std::optional<DriveKey> key) {
    learning_ = key;
    letGo();
    showCaps();
}

bool DriveKeysBox::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::KeyPress && type != QEvent::KeyRelease && type != QEvent::ShortcutOverride)
        return false;
    const auto& key = *static_cast<QKeyEvent*>(event);
    bool taken = false;
    if (type == QEvent::ShortcutOverride) {
        taken = hears(key) && (learning_ || map_.find(key.key()));
    } else if (!watched->isWidgetType()) {
        // On its way to a widget: it passes here again.
        return false;
    } else if (type == QEvent::KeyPress) {
        taken = learn(key) || press(key);
    } else {
        taken = release(key);
    }
    if (taken) event->accept();
    return taken;
}

bool DriveKeysBox::hears(const QKeyEvent& event) const {
    if (!isVisible() || (!learning_ && (!on_->isChecked() || !usable_))) return false;
    if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != 0) return false;
    if (QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr)
        return false;
    const QWidget* focus = QApplication::focusWidget();
    return focus == nullptr || (focus->window() == window() && !takesLetters(focus));
}

bool DriveKeysBox::press(const QKeyEvent& event) {
    const auto key = map_.find(event.key());
    if (!key || !hears(event)) return false;
    const BodyMotion before = held_.direction();
    held_.press(*key, event.isAutoRepeat(), now());
    if (held_.direction() != before) tell();
    return true;
}

bool DriveKeysBox::release(const QKeyEvent& event) {
    const auto key = map_.find(event.key());
    if (!key || !held_.isHeld(*key)) return false;
    // A keyboard's repeats are pairs of a release and a press.
    if (event.isAutoRepeat()) return true;
    held_.release(*key, now());
    tell();
    return true;
}

bool DriveKeysBox::learn(const QKeyEvent& event) {
    if (!learning_ || event.isAutoRepeat() || !hears(event)) return false;
    if (event.key() < Qt::Key_A || event.key() > Qt::Key_Z) return false;
    if (map_.setLetter(*learning_, static_cast<char>(event.key()))) {
        const std::string_view letters = map_.letters();
        settings_.setValue(kLettersSetting, QString::fromLatin1(letters.data(), letters.size()));
        setLearning(std::nullopt);
    } else {
        emit noticed(tr("This letter is taken: it sets the wheels to zero. Press another."));
    }
    return true;
}

void DriveKeysBox::focusMoved() {
    const QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && focus->window() == window() && !takesLetters(focus)) return;
    letGo();
    if (learning_) setLearning(std::nullopt);
}

void DriveKeysBox::tell() {
    if (held_.any()) {
        watch_.start(kWatch);
    } else {
        watch_.stop();
    }
    showCaps();
    emit asked(held_.direction() * (speed_->value() / 100.0));
}

void DriveKeysBox::showCaps() {
    for (const DriveKey key : kDriveKeys) {
        QPushButton* cap = caps_[static_cast<std::size_t>(key)];
        const QString letter(QLatin1Char(map_.letter(key)));
        cap->setText(learning_ == key ? QStringLiteral("?") : letter);
        cap->setChecked(learning_ == key || held_.isHeld(key));
        cap->setAccessibleName(tr("%1: key %2").arg(meaningOf(key), letter));
        cap->setToolTip(learning_ == key
                            ? tr("Press the letter that is to do this.")
                            : tr("%1: %2. Click to choose another letter.").arg(meaningOf(key), letter));
    }
}

void DriveKeysBox::hideEvent(QHideEvent* event) {
    letGo();
    QWidget::hideEvent(event);
}

}  // namespace kickstand::ui
