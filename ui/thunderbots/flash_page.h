#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace kickstand::ui {

/// A page of the firmware wizard: a column that scrolls where the panel is too low for it, and a row above it
/// that stays.
class FlashPageView : public QWidget {
    Q_OBJECT
  public:
    explicit FlashPageView(QWidget* parent);

    /// What does not fit is scrolled here: a page never asks for more room because its texts are long.
    bool hasHeightForWidth() const override { return false; }

  protected:
    /// What scrolls.
    QVBoxLayout* column() const { return column_; }
    QWidget* content() const { return content_; }
    /// What stays above it.
    QVBoxLayout* head() const { return head_; }
    QVBoxLayout* foot() const { return foot_; }
    /// Scrolls until a part of the content can be seen.
    void reveal(QWidget* part) const;
    /// A line or more of plain text.
    QLabel* makeText(const char* name, QWidget* parent) const;
    QPushButton* makeButton(const char* name, const QString& text, QWidget* parent) const;

  private:
    QWidget* content_;
    QScrollArea* scroll_;
    QVBoxLayout* head_;
    QVBoxLayout* column_;
    QVBoxLayout* foot_;
};

}  // namespace kickstand::ui
