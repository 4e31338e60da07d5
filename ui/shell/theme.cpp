#include "ui/shell/theme.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QSettings>
#include <QToolTip>

#include "ui/widgets/bench_style.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr const char* kChoiceSetting = "look/theme";
constexpr const char* kSystemSetting = "look/systemWasDark";
constexpr const char* kService = "org.freedesktop.portal.Desktop";
constexpr const char* kPath = "/org/freedesktop/portal/desktop";
constexpr const char* kInterface = "org.freedesktop.portal.Settings";
constexpr const char* kGroup = "org.freedesktop.appearance";
constexpr const char* kKey = "color-scheme";
constexpr uint kNoPreference = 0;
constexpr uint kPrefersDark = 1;

}  // namespace

Theme::Theme(QSettings& settings, QObject* parent) : QObject(parent), settings_(settings) {
    choice_ = static_cast<ThemeChoice>(settings.value(kChoiceSetting, 0).toInt());
    const bool paletteIsDark = QApplication::palette().color(QPalette::Window).lightness() < 128;
    // The portal answers after the first paint: until then what it said last time holds.
    systemIsDark_ = settings.value(kSystemSetting, paletteIsDark).toBool();
    QApplication::setStyle(new BenchStyle);
    QFont font = QApplication::font();
    font.setPixelSize(metrics::kTextSize);
    QApplication::setFont(font);
    apply();
}

void Theme::choose(ThemeChoice choice) {
    settings_.setValue(kChoiceSetting, static_cast<int>(choice));
    useNow(choice);
}

void Theme::useNow(ThemeChoice choice) {
    if (choice == choice_) return;
    choice_ = choice;
    apply();
}

bool Theme::isDark() const {
    return choice_ == ThemeChoice::System ? systemIsDark_ : choice_ == ThemeChoice::Dark;
}

void Theme::followSystem() {
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) return;
    bus.connect(kService, kPath, kInterface, QStringLiteral("SettingChanged"), this,
                SLOT(settingChanged(QString, QString, QDBusVariant)));
    QDBusMessage call = QDBusMessage::createMethodCall(kService, kPath, kInterface, QStringLiteral("Read"));
    call << QString::fromLatin1(kGroup) << QString::fromLatin1(kKey);
    auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this](QDBusPendingCallWatcher* done) {
        const QDBusPendingReply<QVariant> reply = *done;
        if (!reply.isError()) {
            QVariant value = reply.value();
            if (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
            heardSystem(value.toUInt());
        }
        done->deleteLater();
    });
}

void Theme::settingChanged(const QString& group, const QString& key, const QDBusVariant& value) {
    if (group == QLatin1String(kGroup) && key == QLatin1String(kKey)) heardSystem(value.variant().toUInt());
}

void Theme::heardSystem(uint scheme) {
    if (scheme == kNoPreference) return;
    const bool dark = scheme == kPrefersDark;
    settings_.setValue(kSystemSetting, dark);
    if (dark == systemIsDark_) return;
    systemIsDark_ = dark;
    if (choice_ == ThemeChoice::System) apply();
}

void Theme::apply() {
    const QPalette palette = paletteOf(isDark() ? darkTokens() : lightTokens());
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
    emit changed();
}

}  // namespace kickstand::ui
