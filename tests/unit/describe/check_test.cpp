// The words and files of bench checks.

#include <QJsonArray>
#include <QJsonDocument>
#include <set>

#include <gtest/gtest.h>

#include "core/engine/describe_check.h"
#include "core/engine/describe_check_report.h"

namespace kickstand {
namespace {

using namespace thunderbots;

CheckProgress wholeCheck(RobotMask robots = maskOf(3)) {
    CheckProgress progress;
    progress.plan.robots = robots;
    const auto steps = planCheck(progress.plan).value();
    for (const CheckStep& step : steps)
        progress.rows.push_back({step, CheckVerdict::Passed, {}, {}, {}});
    progress.stage = CheckStage::Ended;
    return progress;
}

TEST(CheckWords, EveryStepHasItsOwnWordsAndWhatIsSeenItsQuestion) {
    std::set<QString> texts;
    for (const CheckRow& row : wholeCheck().rows) {
        EXPECT_TRUE(texts.insert(describe(row.step)).second) << describe(row.step).toStdString();
        const bool seen = row.step.kind == CheckKind::Ready || row.step.kind == CheckKind::Wheel ||
                          row.step.kind == CheckKind::Dribbler || row.step.kind == CheckKind::Lights;
        EXPECT_EQ(!questionText(row.step).isEmpty(), seen) << describe(row.step).toStdString();
        EXPECT_FALSE(workText(row, CheckStage::Running).isEmpty());
    }
}

TEST(CheckWords, EveryLimitHasALabel) {
    for (const CheckLimitInfo& info : checkLimitInfos())
        EXPECT_NE(labelOf(info), QString::fromLatin1(info.name));
}

TEST(CheckWords, TheSentenceNamesWhatDidNotPass) {
    CheckProgress progress = wholeCheck();
    const QString steps = QString::number(progress.rows.size());
    EXPECT_EQ(sentenceOf(progress, 3), QStringLiteral("Robot 3 passed its %1 steps.").arg(steps));
    EXPECT_EQ(sentenceOf(progress), sentenceOf(progress, 3));
    progress.rows[4].verdict = CheckVerdict::NotSeen;
    EXPECT_EQ(sentenceOf(progress, 3),
              QStringLiteral("Robot 3 did not pass: Wheel 2, back left, + (not seen)."));
    EXPECT_EQ(sentenceOf(progress), sentenceOf(progress, 3));
    progress.endedBy = Errc::StopLatched;
    EXPECT_TRUE(sentenceOf(progress).startsWith(QStringLiteral("The check was ended early: ")));
}

TEST(CheckWords, TheSentenceSaysWhatWasLeftOut) {
    const auto progress = [](RobotMask robots) {
        CheckProgress left = wholeCheck(robots);
        left.plan.highVoltage = false;
        left.plan.lights = false;
        return left;
    };
    EXPECT_TRUE(sentenceOf(progress(maskOf(6)))
                    .endsWith(QStringLiteral(" steps. Not checked: charge and kick, test LEDs.")));
    EXPECT_EQ(sentenceOf(progress(maskOf(5) | maskOf(6))),
              QStringLiteral("Passed: robots 5-6. Not checked: charge and kick, test LEDs."));
    EXPECT_TRUE(checkReportText(progress(maskOf(6)), {}).contains(QStringLiteral("Not checked: charge")));
}

TEST(CheckWords, OfSeveralRobotsTheSentenceNamesThoseThatPassedAndTheOthers) {
    CheckProgress progress = wholeCheck(maskOf(3) | maskOf(5) | maskOf(7));
    progress.rows.back().verdict = CheckVerdict::Failed;
    EXPECT_EQ(sentenceOf(progress), QStringLiteral("Passed: robots 3, 5. Not passed: robot 7."));
}

TEST(CheckLimitsFile, WhatWasSavedIsReadAgain) {
    CheckLimits limits;
    limits.leastBattery_V = 14.6;
    limits.wheelSpeed = 35;
    const auto read = checkLimitsFromJson(QJsonDocument(toJson(limits)).toJson());
    ASSERT_TRUE(read) << read.error().toStdString();
    EXPECT_EQ(*read, limits);
    EXPECT_EQ(*checkLimitsFromJson("{}"), CheckLimits{});
}

TEST(CheckLimitsFile, WhatIsWrongIsSaid) {
    const auto whyNot = [](const char* json) {
        const auto read = checkLimitsFromJson(json);
        EXPECT_FALSE(read) << json;
        return read ? std::string() : read.error().toStdString();
    };
    EXPECT_NE(whyNot("").find("no limits"), std::string::npos);
    EXPECT_NE(whyNot("[1]").find("no limits"), std::string::npos);
    EXPECT_NE(whyNot(R"({"speed": 1})").find("speed"), std::string::npos);
    EXPECT_NE(whyNot(R"({"wheel_speed": 101})").find("from 1 to 100"), std::string::npos);
    EXPECT_NE(whyNot(R"({"wheel_speed": "fast"})").find("wheel_speed"), std::string::npos);
    EXPECT_NE(whyNot(R"({"wheel_speed": null})").find("wheel_speed"), std::string::npos);
}

TEST(CheckReport, EachRobotHasItsOwnSheetOnPaper) {
    const QString html = checkReportHtml(wholeCheck(maskOf(3) | maskOf(5) | maskOf(7)), {});
    EXPECT_EQ(html.count(QStringLiteral("page-break-before: always")), 2);
}

TEST(CheckReport, HasEveryStepWithLimitValueAndVerdict) {
    CheckProgress progress = wholeCheck();
    progress.rows[1].value = 15.934;
    progress.rows[1].limit = 15;
    progress.rows.back().verdict = CheckVerdict::Failed;
    progress.rows.back().why = Errc::NotDischarging;
    const QJsonObject report = checkReport(progress, {});
    EXPECT_EQ(report[QStringLiteral("began")].toString(), QStringLiteral("1970-01-01T00:00:00.000Z"));
    const QJsonArray steps = report[QStringLiteral("robots")][0][QStringLiteral("steps")].toArray();
    ASSERT_EQ(steps.size(), static_cast<qsizetype>(progress.rows.size()));
    EXPECT_EQ(steps[1][QStringLiteral("value")].toDouble(), 15.934);
    EXPECT_EQ(steps[1][QStringLiteral("limit")].toDouble(), 15);
    EXPECT_TRUE(steps[2][QStringLiteral("value")].isNull());
    EXPECT_EQ(steps.last()[QStringLiteral("reason")].toString(), QStringLiteral("not-discharging"));
    EXPECT_FALSE(report[QStringLiteral("passed")].toBool(true));

    const QString html = checkReportHtml(progress, {});
    EXPECT_TRUE(html.contains(QStringLiteral("15.93 V"))) << html.toStdString();
    EXPECT_TRUE(html.contains(QStringLiteral("≥ 15.00 V")));
    EXPECT_TRUE(html.contains(QStringLiteral("<b>failed</b>: ")));
    EXPECT_EQ(html.count(QStringLiteral("<tr>")), static_cast<qsizetype>(progress.rows.size()) + 1);

    EXPECT_FALSE(html.contains(QStringLiteral("page-break"))) << "one robot shares the title's page";

    const QString text = checkReportText(progress, {});
    EXPECT_EQ(text.count(u'\n'), static_cast<qsizetype>(progress.rows.size()) + 3);
}

}  // namespace
}  // namespace kickstand
