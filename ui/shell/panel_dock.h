#pragma once

#include <QDockWidget>

class QLabel;

namespace kickstand::ui {

class Panel;

/// A panel in its dock: one rounded surface with a header line.
class PanelDock final : public QDockWidget {
    Q_OBJECT
  public:
    PanelDock(const QString& id, const QString& title, const QString& helpPage, Panel* panel,
              QWidget* parent = nullptr);

    Panel* panel() const { return panel_; }
    const QString& helpPage() const { return helpPage_; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    Panel* panel_;
    QString helpPage_;
};

}  // namespace kickstand::ui
