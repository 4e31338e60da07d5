#include "ui/shell/single_instance.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <memory>

#include <gtest/gtest.h>

#include "tests/ui/bench_rig.h"

namespace kickstand::test {
namespace {

using ui::SingleInstance;

TEST(SingleInstanceTest, TheSecondIsToldAndTheFirstIsAskedToShowItself) {
    const QTemporaryDir folder;
    SingleInstance first(folder.path());
    ASSERT_TRUE(first.claim());
    QSignalSpy asked(&first, &SingleInstance::showAsked);
    SingleInstance second(folder.path());
    EXPECT_FALSE(second.claim());
    EXPECT_TRUE(waitUntil([&asked] { return asked.count() == 1; }));
    SingleInstance third(folder.path());
    EXPECT_FALSE(third.claim());
    EXPECT_TRUE(waitUntil([&asked] { return asked.count() == 2; }));
}

TEST(SingleInstanceTest, WhenTheFirstHasEndedTheNextIsTheFirst) {
    const QTemporaryDir folder;
    auto first = std::make_unique<SingleInstance>(folder.path());
    ASSERT_TRUE(first->claim());
    first.reset();
    SingleInstance next(folder.path());
    EXPECT_TRUE(next.claim());
}

TEST(SingleInstanceTest, WhatACrashLeftBehindKeepsNobodyOut) {
    const QTemporaryDir folder;
    QFile left(folder.filePath(QStringLiteral("kickstand-window")));
    ASSERT_TRUE(left.open(QIODevice::WriteOnly));
    left.close();
    SingleInstance first(folder.path());
    ASSERT_TRUE(first.claim());
    QSignalSpy asked(&first, &SingleInstance::showAsked);
    SingleInstance second(folder.path());
    EXPECT_FALSE(second.claim());
    EXPECT_TRUE(waitUntil([&asked] { return asked.count() == 1; }));
}

TEST(SingleInstanceTest, WithoutAPlaceForALockItStartsAllTheSame) {
    const QTemporaryDir folder;
    SingleInstance alone(folder.filePath(QStringLiteral("missing")));
    EXPECT_TRUE(alone.claim());
}

}  // namespace
}  // namespace kickstand::test
