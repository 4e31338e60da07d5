#include "ui/shell/live_warning.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include "ui/shell/bench.h"

namespace kickstand::ui {

namespace {

QString text(const char* source) {
    return QCoreApplication::translate("LiveWarning", source);
}

}  // namespace

std::vector<Hazard> hazardsOf(const Bench& bench) {
    std::vector<Hazard> all;
    for (const SessionSnapshot& session : bench.client().snapshot().sessions) {
        const SystemView* view = bench.systems().viewOf(session.system);
        if (view == nullptr) continue;
        for (Hazard& hazard : view->hazards(session.system))
            all.push_back(std::move(hazard));
    }
    return all;
}

QString hazardLine(const Hazard& hazard, TimePoint now) {
    if (!hazard.stale) return hazard.text;
    const int age_s = static_cast<int>(seconds(now - hazard.at));
    return text("%1, %2 s ago: treat as live").arg(hazard.text).arg(age_s);
}

QMessageBox* makeLiveWarning(const std::vector<Hazard>& hazards, TimePoint now, const QString& leave,
                             QWidget* parent) {
    QString list;
    for (const Hazard& hazard : hazards) {
        list += QStringLiteral("<li>%1</li>").arg(hazardLine(hazard, now).toHtmlEscaped());
    }
    auto* box = new QMessageBox(QMessageBox::Warning, text("Live capacitors"),
                                QStringLiteral("<b>%1</b>").arg(text("Capacitors are still charged.")),
                                QMessageBox::NoButton, parent);
    box->setObjectName(QStringLiteral("liveWarning"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        QStringLiteral("<ul>%1</ul><p>%2</p>")
            .arg(
                list,
                text("Everything has been braked. Before anybody touches a robot: stay, re-arm, arm its high "
                     "voltage and choose Discharge in the Drive panel.")));
    QPushButton* stay = box->addButton(text("Stay"), QMessageBox::RejectRole);
    QPushButton* go = box->addButton(leave, QMessageBox::AcceptRole);
    stay->setObjectName(QStringLiteral("stay"));
    go->setObjectName(QStringLiteral("leave"));
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    return box;
}

}  // namespace kickstand::ui
