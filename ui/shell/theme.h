#pragma once

#include <QObject>

class QDBusVariant;
class QSettings;

namespace kickstand::ui {

enum class ThemeChoice { System, Light, Dark };

/// Light or dark: as the system has it, or as a person chose. The system's word is the desktop portal's, else
/// the lightness of the palette that the program was started with. GUI thread.
class Theme final : public QObject {
    Q_OBJECT
  public:
    /// Sets the application's style, palette and font. Make it before the first window.
    explicit Theme(QSettings& settings, QObject* parent = nullptr);

    ThemeChoice choice() const { return choice_; }
    /// Remembered.
    void choose(ThemeChoice choice);
    /// For this run only.
    void useNow(ThemeChoice choice);
    bool isDark() const;
    /// Asks the desktop portal, and listens to it. Later than the first paint: the bus may take its time.
    void followSystem();

  signals:
    void changed();

  public slots:
    /// What the portal sends.
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

  private:
    void apply();
    void heardSystem(uint scheme);

    QSettings& settings_;
    ThemeChoice choice_ = ThemeChoice::System;
    bool systemIsDark_ = false;
};

}  // namespace kickstand::ui
