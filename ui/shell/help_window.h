#pragma once

#include <QWidget>

class QTextBrowser;

namespace kickstand::ui {

/// The pages of resources/help, as they are on a forge. Made when it is first asked for.
class HelpWindow final : public QWidget {
    Q_OBJECT
  public:
    explicit HelpWindow(QWidget* parent = nullptr);

    /// "bench-guide.md#events": a heading is brought to the top.
    void showPage(const QString& page);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void showHeading(const QString& anchor);

    QTextBrowser* browser_;
};

}  // namespace kickstand::ui
