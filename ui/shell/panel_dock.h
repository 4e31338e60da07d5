#pragma once

#include <QDockWidget>
#include <functional>

class QHBoxLayout;

namespace kickstand::ui {

class Panel;

/// A panel in its dock: one rounded surface with a header line. The panel is made when it is first asked for:
/// a window of many panels is there much sooner with only those made that can be seen.
class PanelDock final : public QDockWidget {
    Q_OBJECT
  public:
    PanelDock(const QString& id, const QString& title, const QString& helpPage, std::function<Panel*()> make,
              QWidget* parent = nullptr);

    /// Never null.
    Panel* panel();
    bool isMade() const { return panel_ != nullptr; }
    const QString& helpPage() const { return helpPage_; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

  private:
    void makePanel();

    const std::function<Panel*()> make_;
    Panel* panel_ = nullptr;
    QHBoxLayout* headerRow_;
    QString helpPage_;
};

}  // namespace kickstand::ui
