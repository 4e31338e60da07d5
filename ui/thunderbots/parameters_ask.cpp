#include "ui/thunderbots/parameters_ask.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include "core/thunderbots/wire/readings.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ParametersPanel)
};

RobotMask aliveIn(const Snapshot& snapshot) {
    RobotMask alive = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (snapshot.robots[static_cast<std::size_t>(robot)].live)
            alive = static_cast<RobotMask>(alive | maskOf(robot));
    }
    return alive;
}

QString question(ParameterStep step, int robot) {
    switch (step) {
        case ParameterStep::Apply:
            return Words::tr("Apply this to robot %1?").arg(robot);
        case ParameterStep::Commit:
            return Words::tr("Commit this in robot %1?").arg(robot);
        case ParameterStep::Reboot:
            return Words::tr("Reboot robot %1?").arg(robot);
    }
    return {};
}

QString answer(ParameterStep step) {
    switch (step) {
        case ParameterStep::Apply:
            return Words::tr("Apply all the same");
        case ParameterStep::Commit:
            return Words::tr("Commit all the same");
        case ParameterStep::Reboot:
            return Words::tr("Reboot all the same");
    }
    return {};
}

}  // namespace

std::vector<ParameterWarning> warningsBefore(ParameterStep step, int robot,
                                             const wire::OperationalParameters& block,
                                             const Snapshot& snapshot) {
    const ParameterState& state = snapshot.parameters[static_cast<std::size_t>(robot)];
    // What is only being applied is weighed against what is there; what is about to be kept, by itself.
    const auto now = step == ParameterStep::Apply ? state.robot : std::nullopt;
    auto warnings = parameterWarnings(robot, block, now, snapshot.cable ? std::nullopt : snapshot.channels,
                                      aliveIn(snapshot));
    if (step == ParameterStep::Apply) return warnings;
    // An empty flash is the robot's own business, once it is so.
    std::erase_if(warnings,
                  [](const ParameterWarning& warning) { return warning.risk == ParameterRisk::NoBitstream; });
    return warnings;
}

void askBefore(ParameterStep step, int robot, const QStringList& sentences, bool serious, QWidget* parent,
               const std::function<void()>& goOn) {
    if (sentences.isEmpty()) {
        goOn();
        return;
    }
    auto* box = new QMessageBox(serious ? QMessageBox::Warning : QMessageBox::Question, question(step, robot),
                                question(step, robot), QMessageBox::NoButton, parent);
    box->setObjectName(QStringLiteral("parameterQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(sentences.join(QStringLiteral("\n\n")));
    QPushButton* yes = box->addButton(answer(step), QMessageBox::AcceptRole);
    yes->setObjectName(QStringLiteral("parameterYes"));
    QPushButton* no = box->addButton(Words::tr("Do not"), QMessageBox::RejectRole);
    no->setObjectName(QStringLiteral("parameterNo"));
    box->setDefaultButton(no);
    box->setEscapeButton(no);
    QObject::connect(yes, &QPushButton::clicked, parent, goOn);
    box->open();
}

QString reasonNotToAsk(const Snapshot* snapshot, int robot, int chosen) {
    if (snapshot == nullptr || snapshot->link != LinkState::Running)
        return Words::tr("Connect first: parameters live in the robots.");
    if (chosen == 0) return Words::tr("Choose a robot.");
    if (chosen > 1) return Words::tr("Choose one robot: each has parameters of its own.");
    const auto at = static_cast<std::size_t>(robot);
    const ParameterState& state = snapshot->parameters[at];
    if (!snapshot->robots[at].live) {
        return state.movedTo >= 0
                   ? describe(state)
                   : Words::tr("Robot %1 is not heard: switch it on, or wait while it reboots.").arg(robot);
    }
    const RequestState& request = snapshot->requests[at];
    if (!request.op) return {};
    if (request.attempt > 1)
        return Words::tr("Waiting for robot %1, attempt %2 of %3\u2026")
            .arg(robot)
            .arg(request.attempt)
            .arg(request.attempts);
    return Words::tr("Waiting for robot %1\u2026").arg(robot);
}

QString reasonNotToReboot(const Snapshot& snapshot, int robot, bool stopped) {
    const auto at = static_cast<std::size_t>(robot);
    const RobotIntent& intent = snapshot.intents[at];
    if (stopped) return Words::tr("Everything is stopped: re-arm before a reboot.");
    if (intent.run || intent.dribbler || intent.charger || intent.autokick || intent.discharging ||
        intent.sweeping || intent.checking)
        return Words::tr("Before a reboot the robot has to be braked, its charger and autokick off.");
    const RobotState& state = snapshot.robots[at];
    if (!state.capacitor) return Words::tr("Before a reboot the robot's capacitor has to be known.");
    if (state.capacitor->last_V >= wire::kCapacitorLive_V)
        return Words::tr("Before a reboot the capacitor has to be below 50 V, and it is at %1: discharge it.")
            .arg(capacitorText(state.capacitor->last_V));
    return {};
}

}  // namespace kickstand::ui
