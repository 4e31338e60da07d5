#include "ui/shell/event_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

EventLine line(const QString& text, int robot = -1, Severity severity = Severity::Information) {
    EventLine made;
    made.text = text;
    made.robot = robot;
    made.about = robot < 0 ? QString() : QStringLiteral("robot %1").arg(robot);
    made.severity = severity;
    return made;
}

QString text(const QAbstractItemModel& model, int row) {
    return model.index(row, EventModel::Text).data().toString();
}

TEST(EventModel, TheNewestIsAtTheTop) {
    EventModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.add({line(QStringLiteral("a")), line(QStringLiteral("b"))});
    model.add({line(QStringLiteral("c"))});
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(text(model, 0), QStringLiteral("c"));
    EXPECT_EQ(text(model, 1), QStringLiteral("b"));
    EXPECT_EQ(text(model, 2), QStringLiteral("a"));
}

TEST(EventModel, ABatchIsOneInsertion) {
    EventModel model;
    QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    model.add(std::vector<EventLine>(500, line(QStringLiteral("x"))));
    EXPECT_EQ(inserted.count(), 1);
    EXPECT_EQ(model.rowCount(), 500);
}

TEST(EventModel, TheOldestGiveWay) {
    EventModel model(nullptr, 3);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    for (int i = 0; i < 10; ++i)
        model.add({line(QString::number(i))});
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(text(model, 0), QStringLiteral("9"));
    EXPECT_EQ(text(model, 2), QStringLiteral("7"));
    std::vector<EventLine> many;
    for (int i = 100; i < 120; ++i)
        many.push_back(line(QString::number(i)));
    model.add(std::move(many));
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(text(model, 0), QStringLiteral("119"));
    EXPECT_EQ(text(model, 2), QStringLiteral("117"));
}

TEST(EventModel, RefusalsThatRepeatAreCounted) {
    EventModel model;
    EventLine refusal = line(QStringLiteral("refused"), 3, Severity::Warning);
    refusal.countable = true;
    model.add({refusal});
    model.add({refusal});
    model.add({refusal});
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_TRUE(text(model, 0).contains(QStringLiteral("3 times")));
    model.add({line(QStringLiteral("other"))});
    model.add({refusal});
    EXPECT_EQ(model.rowCount(), 3);
    refusal.robot = 4;
    model.add({refusal});
    EXPECT_EQ(model.rowCount(), 4);
}

TEST(EventModel, OrdinaryEventsAreNeverFolded) {
    EventModel model;
    model.add({line(QStringLiteral("kick"), 3)});
    model.add({line(QStringLiteral("kick"), 3)});
    EXPECT_EQ(model.rowCount(), 2);
}

TEST(EventFilter, ShowsWhatWasAskedFor) {
    EventModel model;
    EventFilter filter;
    filter.setSourceModel(&model);
    model.add({line(QStringLiteral("battery low"), 2, Severity::Warning),
               line(QStringLiteral("charger on"), 3), line(QStringLiteral("lost"), 3, Severity::Danger),
               line(QStringLiteral("connected"))});
    EXPECT_EQ(filter.rowCount(), 4);
    filter.setAbout(QStringLiteral("robot 3"));
    EXPECT_EQ(filter.rowCount(), 2);
    filter.setLeast(Severity::Warning);
    EXPECT_EQ(filter.rowCount(), 1);
    filter.setAbout({});
    EXPECT_EQ(filter.rowCount(), 2);
    filter.setText(QStringLiteral("  BATTERY "));
    ASSERT_EQ(filter.rowCount(), 1);
    EXPECT_EQ(text(filter, 0), QStringLiteral("battery low"));
}

}  // namespace
}  // namespace kickstand::ui
