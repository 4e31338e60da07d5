#include "ui/smartdevice/devices_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/smartdevice/commands.h"
#include "ui/shell/bench.h"
#include "ui/smartdevice/device_choice.h"
#include "ui/smartdevice/smartdevice_view.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

DevicesPanel::DevicesPanel(Bench& bench, DeviceChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      list_(new DeviceList(this)),
      empty_(new QLabel(this)),
      remedy_(new QLabel(this)),
      search_(new QPushButton(tr("Search again"), this)) {
    empty_->setObjectName(QStringLiteral("boardsEmpty"));
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    remedy_->setObjectName(QStringLiteral("boardsRemedy"));
    remedy_->setWordWrap(true);
    remedy_->setTextFormat(Qt::PlainText);
    remedy_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    search_->setObjectName(QStringLiteral("boardsSearch"));
    search_->setToolTip(tr("Tries every port again at which no board answered"));
    search_->setAutoDefault(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, metrics::kGap);
    column->setSpacing(metrics::kGap);
    column->addWidget(empty_);
    column->addWidget(list_, 1);
    column->addWidget(remedy_);
    column->addWidget(search_);
    connect(list_, &DeviceList::asked, &choice_, &DeviceChoice::choose);
    connect(list_, &DeviceList::currentLineChanged, this, &DevicesPanel::refreshWords);
    connect(&choice_, &DeviceChoice::changed, this, &DevicesPanel::refresh);
    connect(&bench, &Bench::changed, this, &DevicesPanel::refresh);
    connect(search_, &QPushButton::clicked, this,
            [this] { this->bench().submit(smartdevice::Command(SearchAgain{})); });
    refresh();
}

std::vector<DeviceLine> DevicesPanel::linesOf(const Snapshot& snapshot) const {
    std::vector<DeviceLine> lines;
    const TimePoint now = bench().client().now();
    for (const DeviceState& device : snapshot.devices) {
        const QString kind = QString::fromStdString(device.spec->name);
        DeviceLine line{device.number,
                        kind,
                        titleOf(bench().settings(), device),
                        tr("%1 \u00b7 %2").arg(kind, QString::fromStdString(device.port)),
                        medianText(device),
                        p99Text(device),
                        standingOf(device, now),
                        {}};
        if (device.presence == Presence::Lost) {
            const auto port = std::ranges::find(snapshot.ports, device.port, &PortState::name);
            if (port != snapshot.ports.end()) line.remedy = remedyOf(*port);
            if (line.remedy.isEmpty())
                line.remedy = tr("%1 is lost: check its cable and power. It is found again by itself, and "
                                 "nothing is written to it then.")
                                  .arg(line.title);
        }
        lines.push_back(std::move(line));
    }
    for (const PortState& port : snapshot.ports) {
        // Where a board was it stands above already, as lost.
        const auto known = std::ranges::find(snapshot.devices, port.name, &DeviceState::port);
        if (port.device >= 0 || known != snapshot.devices.end()) continue;
        lines.push_back({-1,
                         {},
                         QString::fromStdString(port.name),
                         QString::fromStdString(port.description),
                         {},
                         {},
                         standingOf(port),
                         remedyOf(port)});
    }
    return lines;
}

void DevicesPanel::refresh() {
    const Snapshot* snapshot = boardsOf(bench().session());
    choice_.follow(snapshot);
    list_->setLines(snapshot == nullptr ? std::vector<DeviceLine>{} : linesOf(*snapshot));
    list_->setChosen(choice_.chosen());
    refreshWords();
}

void DevicesPanel::refreshWords() {
    const Snapshot* snapshot = boardsOf(bench().session());
    const bool none = list_->lines().empty();
    list_->setVisible(!none);
    empty_->setVisible(none);
    if (snapshot == nullptr)
        empty_->setText(tr("Not connected."));
    else if (snapshot->link != LinkState::Running)
        empty_->setText(tr("Looking for serial ports."));
    else
        empty_->setText(tr("There is no serial port on USB. Plug a board in: it is found by itself."));
    search_->setEnabled(snapshot != nullptr);
    // What the chosen line is about; else the first port that wants something done.
    QString remedy;
    for (const DeviceLine& line : list_->lines()) {
        if (remedy.isEmpty()) remedy = line.remedy;
    }
    if (const DeviceLine* line = list_->currentLine(); line != nullptr && !line->remedy.isEmpty())
        remedy = line->remedy;
    if (remedy_->text() != remedy) remedy_->setText(remedy);
    remedy_->setVisible(!remedy.isEmpty());
    const auto live =
        snapshot == nullptr ? 0 : std::ranges::count_if(snapshot->devices, [](const auto& device) {
            return device.presence == Presence::Live;
        });
    setNote(snapshot == nullptr ? QString() : tr("%n live", nullptr, static_cast<int>(live)));
}

}  // namespace kickstand::ui
