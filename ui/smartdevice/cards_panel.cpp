#include "ui/smartdevice/cards_panel.h"

#include <QLabel>
#include <algorithm>

#include "ui/shell/bench.h"
#include "ui/smartdevice/device_card.h"
#include "ui/smartdevice/device_choice.h"
#include "ui/smartdevice/smartdevice_view.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

constexpr int kMargin = metrics::kGap;
constexpr int kGap = metrics::kGap;
constexpr int kUsualColumns = 4;

}  // namespace

CardsPanel::CardsPanel(Bench& bench, DeviceChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      empty_(new QLabel(tr("No board is there yet. Each one gets a card here as it is found."), this)) {
    empty_->setObjectName(QStringLiteral("cardsEmpty"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    connect(&bench, &Bench::changed, this, &CardsPanel::refresh);
    connect(&choice_, &DeviceChoice::changed, this, &CardsPanel::refresh);
    refresh();
}

QSize CardsPanel::sizeHint() const {
    return {kUsualColumns * (DeviceCard::kWidth + kGap) + 2 * kMargin, 2 * (DeviceCard::kHeight + kGap)};
}

void CardsPanel::addCard(int device) {
    auto* card = new DeviceCard(this);
    card->setObjectName(QStringLiteral("card%1").arg(device));
    card->setToolTip(tr("Shows all its parameters"));
    connect(card, &DeviceCard::clicked, this, [this, device] {
        choice_.choose(device);
        refresh();
        bench().goTo(QStringLiteral("board"));
    });
    card->show();
    cards_.push_back(card);
}

void CardsPanel::refresh() {
    const Snapshot* snapshot = boardsOf(bench().session());
    choice_.follow(snapshot);
    const std::size_t count = snapshot == nullptr ? 0 : snapshot->devices.size();
    const bool different = count != cards_.size();
    while (cards_.size() > count) {
        delete cards_.back();
        cards_.pop_back();
    }
    while (cards_.size() < count)
        addCard(static_cast<int>(cards_.size()));
    empty_->setVisible(count == 0);
    bool moved = different;
    const TimePoint now = bench().client().now();
    for (std::size_t i = 0; i < count; ++i) {
        const DeviceState& device = snapshot->devices[i];
        const int span = cards_[i]->span();
        cards_[i]->showCard(titleOf(bench().settings(), device), QString::fromStdString(device.spec->name),
                            standingOf(device, now), cardOf(device, now), device.presence != Presence::Live);
        cards_[i]->setChecked(choice_.chosen() == device.number);
        moved = moved || span != cards_[i]->span();
    }
    if (moved) place();
}

void CardsPanel::place() {
    empty_->setGeometry(rect().adjusted(kMargin, kMargin, -kMargin, -kMargin));
    const int columns = std::max(1, (width() - 2 * kMargin + kGap) / (DeviceCard::kWidth + kGap));
    // What is left over widens the cards, evenly.
    const int each = std::max(DeviceCard::kWidth, (width() - 2 * kMargin + kGap) / columns - kGap);
    int column = 0;
    int row = 0;
    for (DeviceCard* card : cards_) {
        const int span = std::min(card->span(), columns);
        if (column + span > columns) {
            column = 0;
            ++row;
        }
        card->setGeometry(kMargin + column * (each + kGap), kMargin + row * (DeviceCard::kHeight + kGap),
                          span * each + (span - 1) * kGap, DeviceCard::kHeight);
        column += span;
    }
    const int height = cards_.empty() ? 0 : kMargin + (row + 1) * (DeviceCard::kHeight + kGap);
    if (minimumHeight() != height) setMinimumHeight(height);
}

void CardsPanel::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    place();
}

}  // namespace kickstand::ui
