#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace kickstand::ui {

/// A strip across its parent that says one thing: a permanent state, or what is wrong and what to do about
/// it.
class Banner final : public QWidget {
    Q_OBJECT
  public:
    enum class Kind { Notice, Warning, Danger };

    explicit Banner(Kind kind, QWidget* parent = nullptr);

    /// `strong` stands before `text`, in bold.
    void setText(const QString& strong, const QString& text);
    QString text() const;
    void setKind(Kind kind);
    /// Adds a button at the right end; the banner owns it. It can never be a default button.
    QPushButton* addButton(const QString& text);
    /// The same for any other widget.
    void addTrailing(QWidget* widget);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void recolour();

    Kind kind_;
    QString strong_;
    QString text_;
    QLabel* label_;
    QHBoxLayout* row_;
};

}  // namespace kickstand::ui
