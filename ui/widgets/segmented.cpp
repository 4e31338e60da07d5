#include "ui/widgets/segmented.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "ui/widgets/bench_style.h"

namespace kickstand::ui {

Segmented::Segmented(const QStringList& labels, QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (int i = 0; i < labels.size(); ++i) {
        auto* button = new QPushButton(labels[i], this);
        button->setCheckable(true);
        button->setAutoDefault(false);
        const bool first = i == 0;
        const bool last = i == labels.size() - 1;
        setButtonEdge(button, first ? ButtonEdge::First : last ? ButtonEdge::Last : ButtonEdge::Middle);
        connect(button, &QPushButton::clicked, this, [this, i] {
            // A checkable button has turned itself; what is true comes back through setCurrent().
            setCurrent(current_);
            emit asked(i);
        });
        row->addWidget(button);
        buttons_.push_back(button);
    }
}

void Segmented::setCurrent(int index) {
    current_ = index;
    for (std::size_t i = 0; i < buttons_.size(); ++i)
        buttons_[i]->setChecked(static_cast<int>(i) == index);
}

}  // namespace kickstand::ui
