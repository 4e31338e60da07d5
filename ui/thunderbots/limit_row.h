#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace kickstand::ui {

class SignedSpinBox;

/// "limit ±100 raise…": raising asks first, in place, and says what it means.
class LimitRow final : public QWidget {
    Q_OBJECT
  public:
    explicit LimitRow(QWidget* parent = nullptr);

    void setLimit(int limit);

  signals:
    void asked(int limit);

  private:
    void setAsking(bool asking);

    int limit_ = 0;
    QLabel* label_;
    QPushButton* change_;
    SignedSpinBox* wanted_;
    QPushButton* raise_;
    QPushButton* keep_;
};

}  // namespace kickstand::ui
