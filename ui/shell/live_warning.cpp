#include "ui/shell/live_warning.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cstddef>

#include "ui/shell/bench.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr QSize kPicture(40, 40);
constexpr int kTextWidth = 420;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(LiveWarning)
};

QPixmap boltPicture(const QWidget& widget) {
    QPixmap picture(kPicture * widget.devicePixelRatio());
    picture.setDevicePixelRatio(widget.devicePixelRatio());
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    drawBolt(painter,
             QRectF(QPointF(kPicture.width() * 0.2, 0), QSizeF(kPicture.width() * 0.6, kPicture.height())),
             tokensOf(widget.palette()).danger);
    return picture;
}

/// What to do: a robot that is lost cannot be discharged from here.
QString remedy(const std::vector<Hazard>& hazards) {
    const auto any = [&hazards](bool moves, bool stale) {
        return std::any_of(hazards.begin(), hazards.end(), [moves, stale](const Hazard& hazard) {
            return hazard.moves == moves && hazard.stale == stale;
        });
    };
    QStringList sentences{Words::tr("Everything has been braked.")};
    if (any(false, false)) {
        sentences << Words::tr(
            "Before anybody touches a robot: stay, re-arm, arm its high voltage and choose Discharge "
            "in the Drive panel.");
    }
    if (any(false, true)) {
        sentences << Words::tr(
            "A robot that is not heard cannot be discharged from here: switch it on again and bring "
            "it near, or treat it as live and measure before touching it.");
    }
    if (any(true, false)) {
        sentences << Words::tr(
            "A robot that starts a plan when its connection ends moves as soon as you leave: keep clear of "
            "it, or switch it off first.");
    }
    if (any(true, true)) {
        sentences << Words::tr("A robot out of reach cannot be stopped from here: keep clear of it.");
    }
    return sentences.join(u' ');
}

bool anyCapacitor(const std::vector<Hazard>& hazards) {
    return std::any_of(hazards.begin(), hazards.end(), [](const Hazard& hazard) { return !hazard.moves; });
}

}  // namespace

std::vector<Hazard> hazardsOf(const Bench& bench) {
    std::vector<Hazard> all = bench.leftBehind();
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
    if (hazard.moves) return Words::tr("%1, %2 s ago: keep clear").arg(hazard.text).arg(age_s);
    return Words::tr("%1, %2 s ago: treat as live").arg(hazard.text).arg(age_s);
}

QMessageBox* makeLiveWarning(const std::vector<Hazard>& hazards, TimePoint now, const QString& leave,
                             QWidget* parent) {
    QString list;
    for (const Hazard& hazard : hazards) {
        list += QStringLiteral("<li>%1</li>").arg(hazardLine(hazard, now).toHtmlEscaped());
    }
    const bool charged = anyCapacitor(hazards);
    auto* box = new QMessageBox(QMessageBox::NoIcon,
                                charged ? Words::tr("Live capacitors") : Words::tr("Robots that move"),
                                QStringLiteral("<b style=\"font-size:15px\">%1</b>")
                                    .arg(charged ? Words::tr("Capacitors are still charged.")
                                                 : Words::tr("A robot will move, or does.")),
                                QMessageBox::NoButton, parent);
    box->setIconPixmap(boltPicture(*parent));
    box->setObjectName(QStringLiteral("liveWarning"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(
        QStringLiteral("<table width=\"%1\"><tr><td><ul>%2</ul><p>%3</p></td></tr></table>")
            .arg(kTextWidth)
            .arg(list, remedy(hazards)));
    QPushButton* stay = box->addButton(Words::tr("Stay"), QMessageBox::RejectRole);
    QPushButton* go = box->addButton(leave, QMessageBox::AcceptRole);
    stay->setObjectName(QStringLiteral("stay"));
    go->setObjectName(QStringLiteral("leave"));
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    return box;
}

}  // namespace kickstand::ui
