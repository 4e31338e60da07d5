#include "ui/shell/connector.h"

#include <QInputDialog>
#include <QMenu>
#include <QSettings>
#include <chrono>
#include <utility>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/shell/port_offers.h"
#include "ui/shell/system_view.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

constexpr const char* kRecentSetting = "links/recent";
constexpr int kMostRecent = 5;
/// How often hardware is looked for while nothing is connected.
constexpr auto kLookInterval = 2s;

}  // namespace

Connector::Connector(Bench& bench, QWidget* window)
    : QObject(window), bench_(bench), window_(window), menu_(new QMenu(window)) {
    menu_->setObjectName(QStringLiteral("connectMenu"));
    menu_->setToolTipsVisible(true);
    connect(menu_, &QMenu::aboutToShow, this, &Connector::fillMenu);
    connect(&bench_, &Bench::changed, this, &Connector::follow);
    connect(&look_, &QTimer::timeout, this, &Connector::lookAgain);
    lookAgain();
    look_.start(kLookInterval);
}

void Connector::connectTo(const LinkUri& uri) {
    waitsForHardware_ = false;
    remember(uri);
    bench_.connectTo(uri);
}

void Connector::connectBeside(const LinkUri& uri) {
    waitsForHardware_ = false;
    remember(uri);
    bench_.connectBeside(uri);
}

void Connector::askForLink() {
    auto* dialog = new QInputDialog(window_);
    dialog->setObjectName(QStringLiteral("linkDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Enter link"));
    dialog->setLabelText(tr("A link, such as usb:?port=1-2.3 or sim:thunderbots?robots=0-3&loss=0.02"));
    dialog->setTextValue(bench_.settings().value(kRecentSetting).toStringList().value(0));
    dialog->setMinimumWidth(480);
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
        const Result<LinkUri> uri = parseLinkUri(text.trimmed().toStdString());
        if (uri) {
            connectTo(*uri);
        } else {
            emit obstructed(uri.error());
        }
    });
    dialog->open();
}

void Connector::lookAgain() {
    // A link that runs knows more about its device than a look from outside.
    if (bench_.session() == nullptr) bench_.client().submit(0, Discover{});
}

QString Connector::titleOf(const FoundDevice& found) {
    QString name = QString::fromStdString(found.info.productName);
    if (name.isEmpty()) {
        name = tr("USB device %1:%2")
                   .arg(found.info.vendor, 4, 16, QLatin1Char('0'))
                   .arg(found.info.product, 4, 16, QLatin1Char('0'));
    }
    if (found.info.port.empty()) return name;
    return tr("%1 \u00b7 USB %2").arg(name, QString::fromStdString(found.info.port));
}

void Connector::fillMenu() {
    menu_->clear();
    // Their menus outlive actions.
    for (QMenu* const old : menu_->findChildren<QMenu*>())
        old->deleteLater();
    bench_.client().submit(0, Discover{});
    addFound();
    addPorts();
    addOffers(tr("Hardware to look for"), false);
    addOffers(tr("Simulated"), true);
    addRecent();
    addSessions();
}

void Connector::addFound() {
    menu_->addSection(tr("Found"));
    const EngineSnapshot& snapshot = bench_.client().snapshot();
    for (const FoundDevice& found : snapshot.found) {
        QString title = titleOf(found);
        if (found.obstacle) title += tr(" \u2014 cannot be opened: why?");
        QAction* action = menu_->addAction(title);
        connect(action, &QAction::triggered, this, [this, found] {
            if (found.obstacle) {
                emit obstructed(*found.obstacle);
            } else {
                connectTo(found.uri);
            }
        });
    }
    if (snapshot.found.empty()) {
        menu_->addAction(snapshot.discovered ? tr("No hardware found") : tr("Looking\u2026"))
            ->setEnabled(false);
    }
}

void Connector::addPorts() {
    const EngineSnapshot& snapshot = bench_.client().snapshot();
    if (snapshot.ports.empty()) return;
    menu_->addSection(tr("Serial ports"));
    for (const BytePort& port : snapshot.ports) {
        QMenu* const systems = menu_->addMenu(ui::titleOf(port));
        systems->setToolTipsVisible(true);
        ui::addOffers(*systems, port, bench_.systems(), *this);
    }
}

void Connector::addOffers(const QString& title, bool simulated) {
    bool any = false;
    for (const auto& view : bench_.systems().views()) {
        for (const LinkOffer& offer : view->offers()) {
            if (offer.uri.isSimulated() != simulated) continue;
            if (!std::exchange(any, true)) menu_->addSection(title);
            QAction* action = menu_->addAction(offer.title);
            action->setToolTip(offer.explanation);
            connect(action, &QAction::triggered, this, [this, uri = offer.uri] { connectTo(uri); });
        }
    }
}

void Connector::addRecent() {
    menu_->addSeparator();
    menu_->addAction(tr("Enter &link\u2026"), this, &Connector::askForLink);
    const QStringList recent = bench_.settings().value(kRecentSetting).toStringList();
    if (recent.isEmpty()) return;
    QMenu* list = menu_->addMenu(tr("&Recent"));
    for (const QString& text : recent) {
        const Result<LinkUri> uri = parseLinkUri(text.toStdString());
        if (uri) list->addAction(text, this, [this, link = *uri] { connectTo(link); });
    }
}

void Connector::addSessions() {
    const auto& sessions = bench_.client().snapshot().sessions;
    if (sessions.size() > 1) {
        menu_->addSection(tr("Connected"));
        for (const SessionSnapshot& session : sessions) {
            QAction* action = menu_->addAction(QString::fromStdString(toString(session.uri)));
            action->setCheckable(true);
            action->setChecked(session.id == bench_.sessionId());
            connect(action, &QAction::triggered, this, [this, id = session.id] { bench_.show(id); });
        }
    }
    menu_->addSeparator();
    QAction* disconnect = menu_->addAction(tr("&Disconnect"), this, [this] {
        if (bench_.session() != nullptr) bench_.client().submit(bench_.sessionId(), Disconnect{});
    });
    disconnect->setEnabled(bench_.session() != nullptr);
}

void Connector::remember(const LinkUri& uri) {
    const QString text = QString::fromStdString(toString(uri));
    QStringList recent = bench_.settings().value(kRecentSetting).toStringList();
    recent.removeAll(text);
    recent.prepend(text);
    while (recent.size() > kMostRecent)
        recent.removeLast();
    bench_.settings().setValue(kRecentSetting, recent);
}

void Connector::follow() {
    const EngineSnapshot& snapshot = bench_.client().snapshot();
    if (!waitsForHardware_ || !snapshot.discovered) return;
    // Asked once, at the start: what is plugged in later is offered.
    waitsForHardware_ = false;
    if (snapshot.found.size() != 1 || !snapshot.sessions.empty()) return;
    const FoundDevice& found = snapshot.found.front();
    if (found.obstacle) {
        emit obstructed(*found.obstacle);
    } else {
        connectTo(found.uri);
    }
}

}  // namespace kickstand::ui
