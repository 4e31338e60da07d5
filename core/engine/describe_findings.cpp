#include "core/engine/describe_findings.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/engine/describe_facts.h"
#include "core/engine/describe_smartdevice.h"

namespace kickstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Doctor)
};

Description only(const QString& what) {
    return {what, {}, {}};
}

QString uriText(const Finding& finding) {
    return finding.link ? printable(toString(*finding.link)) : QString();
}

Description device(const Finding& finding) {
    if (finding.error) return describe(*finding.error);
    if (finding.serial) return only(Words::tr("There is a serial port %1.").arg(printable(finding.port)));
    return only(Words::tr("%1 is plugged in at %2.").arg(uriText(finding), printable(finding.port)));
}

Description permission(const Finding& finding) {
    if (finding.serial && finding.error) return describe(*finding.error);
    if (finding.serial)
        return only(Words::tr("This user may open the serial port %1.").arg(printable(finding.port)));
    const QString rule = printable(finding.rule);
    if (!finding.error && finding.rule.empty())
        return only(Words::tr("This user may open the device at %1, without a udev rule.")
                        .arg(printable(finding.port)));
    if (!finding.error)
        return only(Words::tr("This user may open the device at %1; the udev rule is %2.")
                        .arg(printable(finding.port), rule));
    Description words = describe(*finding.error);
    if (finding.rule.empty()) return words;
    words.what += QLatin1Char(' ') + Words::tr("The udev rule is there (%1).").arg(rule);
    words.remedy = Words::tr(
        "Unplug the device and plug it in again. Over ssh you must be a member of plugdev, and log in again "
        "after:");
    words.remedyCommand = QStringLiteral("sudo usermod -aG plugdev $USER");
    return words;
}

Description claim(const Finding& finding) {
    const QString port = printable(finding.port);
    if (!finding.error && finding.serial)
        return only(Words::tr("No other program holds the serial port %1.").arg(port));
    if (!finding.error) return only(Words::tr("No other program holds the device at %1.").arg(port));
    if (finding.serial) return describe(*finding.error);
    Description words = describe(*finding.error);
    if (finding.holder) {
        words.what = Words::tr("The device at %1 is held by %2 (process %3).")
                         .arg(port, printable(finding.holder->name))
                         .arg(finding.holder->pid);
        words.remedy = Words::tr("Close that program.");
    } else {
        words.remedy = Words::tr(
            "Close that program; it belongs to somebody else, so only root can see which one it is.");
    }
    return words;
}

QString deviceText(const Finding& finding) {
    const QString kind = finding.cable ? Words::tr("cabled robot") : Words::tr("dongle");
    if (finding.link && finding.link->isSimulated()) return Words::tr("simulated %1").arg(kind);
    return Words::tr("%1 at %2").arg(kind, printable(finding.port));
}

Description link(const Finding& finding) {
    if (finding.error) return describe(*finding.error);
    if (finding.state == CheckState::Ok && finding.serial)
        return only(Words::tr("%1 runs.").arg(uriText(finding)));
    if (finding.state == CheckState::Ok)
        return only(Words::tr("%1 runs: %2.").arg(uriText(finding), deviceText(finding)));
    return {Words::tr("%1 does not run yet: %2.").arg(uriText(finding), describe(finding.linkState)),
            Words::tr("Wait a moment; plug the device in if it is not."),
            {}};
}

Description stop(const Finding& finding) {
    if (finding.state == CheckState::Ok) return only(Words::tr("STOP is not latched."));
    return {Words::tr("Everything is stopped: %1.").arg(describe(finding.stop)),
            Words::tr("Look at the robots, then re-arm."),
            {}};
}

Description radios(const Finding& finding) {
    if (finding.cable) return only(Words::tr("A cable needs none."));
    if (finding.state == CheckState::Problem)
        return {Words::tr("The dongle's radios: %1.").arg(describe(finding.radios)),
                Words::tr("Unplug the dongle and plug it in again."),
                {}};
    if (!finding.channels) return only(Words::tr("The dongle's radios run."));
    return only(Words::tr("The dongle's radios run on channels %1 and %2.")
                    .arg(finding.channels->channel0)
                    .arg(finding.channels->channel1));
}

Description emergencyStop(const Finding& finding) {
    if (finding.state == CheckState::Ok) return only(Words::tr("The emergency stop is at “run”."));
    Description words = describe(Error{.code = Errc::EmergencyStopNotRun});
    words.what = Words::tr("The emergency stop: %1.").arg(describe(finding.eStop));
    return words;
}

Description robots(const Finding& finding) {
    if (finding.state == CheckState::Ok)
        return only(Words::tr("Heard: %1.").arg(describeRobots(finding.robots)));
    return {
        Words::tr("No robot is heard."),
        Words::tr("Switch one on; check that its battery is full and that its channels are the dongle's."),
        {}};
}

Description feedback(const Finding& finding) {
    if (finding.state == CheckState::Ok)
        return only(Words::tr("Every robot that is heard sends its readings."));
    return {Words::tr("No readings come from %1.").arg(describeRobots(finding.robots)),
            Words::tr("Wait a moment and look again; if it stays so, switch it off and on."),
            {}};
}

Description battery(const Finding& finding) {
    if (finding.state == CheckState::Ok) return only(Words::tr("No battery is low."));
    return {Words::tr("The battery is low: %1.").arg(describeRobots(finding.robots)),
            Words::tr("Change it soon."),
            {}};
}

Description traffic(const Finding& finding) {
    if (finding.state == CheckState::Ok) return only(Words::tr("Nothing on the link is damaged."));
    return {Words::tr("Damaged or refused on the link: unreadable %1, stalls %2, reported by the dongle %3.")
                .arg(finding.traffic.malformed)
                .arg(finding.traffic.stalls)
                .arg(finding.traffic.dongleErrors),
            Words::tr("A few of them do no harm; the events show each."),
            {}};
}

Description noAnswer(Answerer answerer) {
    switch (answerer) {
        case Answerer::Nxt:
            return {Words::tr("The port is open, and no NXT answers."),
                    Words::tr("Switch the NXT on, and check that this port is the one of its Bluetooth."),
                    {}};
        case Answerer::Radio:
            return describe(Error{.code = Errc::RadioNotReady});
        case Answerer::Board:
            return {Words::tr("No board answers."),
                    Words::tr("Plug one in; one that starts takes some seconds. If it stays so, its firmware "
                              "speaks another protocol."),
                    {}};
    }
    return {};
}

Description answers(const Finding& finding) {
    if (finding.error) return describe(*finding.error);
    if (finding.state != CheckState::Ok) return noAnswer(finding.answerer);
    switch (finding.answerer) {
        case Answerer::Nxt:
            return only(Words::tr("The NXT answers, and a program runs on it."));
        case Answerer::Radio:
            return only(Words::tr("A radio module in API mode answers."));
        case Answerer::Board:
            return only(Words::tr("Boards that answer: %1.").arg(finding.answering));
    }
    return {};
}

}  // namespace

Description describe(const Finding& finding) {
    if (finding.state == CheckState::NotChecked)
        return only(Words::tr("Not looked at: something before it is wrong."));
    switch (finding.check) {
        case Check::Program:
            return only(Words::tr("%1 %2 with Qt %3 works.")
                            .arg(QCoreApplication::applicationName(), QCoreApplication::applicationVersion(),
                                 QLatin1String(qVersion())));
        case Check::Device:
            return device(finding);
        case Check::Permission:
            return permission(finding);
        case Check::Claim:
            return claim(finding);
        case Check::Link:
            return link(finding);
        case Check::Stop:
            return stop(finding);
        case Check::Radios:
            return radios(finding);
        case Check::EmergencyStop:
            return emergencyStop(finding);
        case Check::Robots:
            return robots(finding);
        case Check::Feedback:
            return feedback(finding);
        case Check::Battery:
            return battery(finding);
        case Check::Traffic:
            return traffic(finding);
        case Check::Answers:
            return answers(finding);
        case Check::Catalogue:
            return finding.error ? describeCatalogueError(*finding.error) : Description{};
    }
    return {};
}

QString describe(Check check) {
    switch (check) {
        case Check::Program:
            return Words::tr("Program");
        case Check::Device:
            return Words::tr("Device");
        case Check::Permission:
            return Words::tr("Permission");
        case Check::Claim:
            return Words::tr("Other programs");
        case Check::Link:
            return Words::tr("Link");
        case Check::Stop:
            return Words::tr("STOP");
        case Check::Radios:
            return Words::tr("Radios");
        case Check::EmergencyStop:
            return Words::tr("Emergency stop");
        case Check::Robots:
            return Words::tr("Robots");
        case Check::Feedback:
            return Words::tr("Readings");
        case Check::Battery:
            return Words::tr("Batteries");
        case Check::Traffic:
            return Words::tr("Traffic");
        case Check::Answers:
            return Words::tr("Answers");
        case Check::Catalogue:
            return Words::tr("Catalogue");
    }
    return {};
}

QString describe(CheckState state) {
    switch (state) {
        case CheckState::Ok:
            return Words::tr("ok");
        case CheckState::Warning:
            return Words::tr("look");
        case CheckState::Problem:
            return Words::tr("wrong");
        case CheckState::NotChecked:
            return Words::tr("unknown");
    }
    return {};
}

QString describeRobots(thunderbots::RobotMask robots) {
    QStringList runs;
    for (int first = 0; first < thunderbots::kRobots; ++first) {
        if (!thunderbots::contains(robots, first)) continue;
        int last = first;
        while (last + 1 < thunderbots::kRobots && thunderbots::contains(robots, last + 1))
            ++last;
        runs << (last > first ? QStringLiteral("%1-%2").arg(first).arg(last) : QString::number(first));
        first = last;
    }
    const bool several = (robots & (robots - 1)) != 0;
    return (several ? Words::tr("robots %1") : Words::tr("robot %1")).arg(runs.join(QStringLiteral(", ")));
}

}  // namespace kickstand
