#pragma once

#include <QWidget>
#include <vector>

class QPushButton;

namespace kickstand::ui {

/// A choice of a few, as joined buttons. It shows what it is told; a click only asks.
class Segmented final : public QWidget {
    Q_OBJECT
  public:
    explicit Segmented(const QStringList& labels, QWidget* parent = nullptr);

    /// Marks one of the buttons, or none with -1. Emits nothing.
    void setCurrent(int index);
    int current() const { return current_; }
    QPushButton* button(int index) const { return buttons_[static_cast<std::size_t>(index)]; }

  signals:
    /// A person asked for this one.
    void asked(int index);

  private:
    std::vector<QPushButton*> buttons_;
    int current_ = -1;
};

}  // namespace kickstand::ui
