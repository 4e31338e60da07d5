// What the cards say of a board's values, and the cards and plots of the window on simulated boards.
#include <QTreeWidget>

#include "tests/ui/board_window.h"
#include "ui/plot/time_plot.h"
#include "ui/shell/panel_dock.h"
#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_card.h"
#include "ui/smartdevice/device_words.h"
#include "ui/smartdevice/plot_choice.h"

namespace kickstand::test {
namespace {

using namespace smartdevice;
using ui::CardContent;
using ui::CardPart;

constexpr TimePoint kNow{std::chrono::seconds(100)};

/// A live board of the built-in catalogue with these values, which have just come.
DeviceState boardWith(const char* kind, const std::vector<std::pair<const char*, wire::Value>>& values) {
    DeviceState device;
    device.spec = makeCatalogue()->find(kind);
    device.presence = Presence::Live;
    device.heardAt = kNow;
    device.parameters.resize(device.spec->parameters.size());
    for (const auto& [name, value] : values) {
        ParameterState& state = device.parameters.at(static_cast<std::size_t>(device.spec->find(name)));
        state.value = value;
        state.at = kNow;
    }
    return device;
}

std::string wordsOf(const DeviceState& device, TimePoint now = kNow) {
    return ui::cardWords(ui::cardOf(device, now)).toStdString();
}

TEST(BoardCardTest, AMotorShowsDutyCyclePositionSpeedCurrentSetPointsAndGains) {
    DeviceState motor = boardWith("PolarBear", {{"duty_cycle", -0.4F},
                                                {"enc_pos", 6600.0F},
                                                {"enc_vel", -2200.0F},
                                                {"motor_current", 1.5F},
                                                {"deadband", 0.1F}});
    const auto at = [&](const char* name) -> ParameterState& {
        return motor.parameters[static_cast<std::size_t>(motor.spec->find(name))];
    };
    at("current_thresh").written = wire::Value(3.0F);
    at("pid_pos_setpoint").written = wire::Value(4400.0F);
    at("pid_vel_kp").written = wire::Value(0.5F);
    const CardContent card = ui::cardOf(motor, kNow);
    EXPECT_EQ(card.width, 2);
    ASSERT_EQ(card.columns.size(), 4U);
    const CardPart& duty = card.columns[0][1];
    EXPECT_NEAR(duty.value.value_or(9), -0.4, 1e-6);
    EXPECT_NEAR(duty.low, -0.1, 1e-6);
    EXPECT_NEAR(duty.high, 0.1, 1e-6);
    EXPECT_NEAR(card.columns[1][0].value.value_or(9), 1.5, 1e-6);
    // Half of the threshold, which stands at four fifths.
    EXPECT_NEAR(card.columns[2][1].value.value_or(9), 0.4, 1e-6);
    const std::string words = ui::cardWords(card).toStdString();
    for (const char* part : {"duty cycle \u22120.40", "deadband 0.10", "1.50 turns 6600\u00a0ticks",
                             "\u22120.50 turns/s \u22122200\u00a0ticks/s", "current 1.50\u00a0A of 3.0 A",
                             "position to 4400 ticks", "P 0.5 I \u2014 D \u2014"})
        EXPECT_NE(words.find(part), std::string::npos) << part << " is not in: " << words;
}

TEST(BoardCardTest, OnlyWhatCanBeWrittenToIsSaidToBeDisabled) {
    for (const auto& [kind, isSaid] : {std::pair{"TeamFlag", true}, std::pair{"LimitSwitch", false}}) {
        DeviceState board = boardWith(kind, {});
        board.disabled = true;
        EXPECT_EQ(ui::standingOf(board, kNow).text == QStringLiteral("disabled"), isSaid) << kind;
    }
}

TEST(BoardCardTest, ABatteryShowsItsCellsFromTheTaps) {
    const auto battery = [](bool unsafe, float third) {
        return boardWith("BatteryBuzzer", {{"is_unsafe", unsafe},
                                           {"calibrated", true},
                                           {"v_cell1", 3.9F},
                                           {"v_cell2", 7.8F},
                                           {"v_cell3", 7.8F + third},
                                           {"v_batt", 7.8F + third},
                                           {"dv_cell2", 3.9F},
                                           {"dv_cell3", third}});
    };
    const std::string safe = wordsOf(battery(false, 3.85F));
    for (const char* part : {"battery 11.65\u00a0V", "safe", "calibrated", "cell 1 3.90\u00a0V",
                             "cell 2 3.90\u00a0V", "cell 3 3.85\u00a0V", "apart 0.05 V"})
        EXPECT_NE(safe.find(part), std::string::npos) << part << " is not in: " << safe;
    const DeviceState bad = battery(true, 3.0F);
    EXPECT_NE(wordsOf(bad).find("alarm: unsafe"), std::string::npos);
    EXPECT_EQ(ui::cardOf(bad, kNow).columns[0][1].tone, ui::Tone::Danger);
}

TEST(BoardCardTest, SensorsSayWhatTheySee) {
    EXPECT_EQ(wordsOf(boardWith("LimitSwitch", {{"switch0", false}, {"switch1", true}, {"switch2", false}})),
              "1 closed");
    const auto line = [](float left, float centre, float right) {
        return wordsOf(boardWith("LineFollower", {{"left", left}, {"center", centre}, {"right", right}}));
    };
    EXPECT_EQ(line(0.9F, 0.3F, 0.1F), "left 0.90, centre 0.30, right 0.10, tape at the left");
    EXPECT_NE(line(0.1F, 0.9F, 0.1F).find("tape in the middle"), std::string::npos);
    EXPECT_NE(line(0.1F, 0.2F, 0.9F).find("tape at the right"), std::string::npos);
    EXPECT_NE(line(0.05F, 0.05F, 0.1F).find("no tape"), std::string::npos);
    EXPECT_EQ(wordsOf(boardWith("Potentiometer", {{"pot0", 0.25F}, {"pot1", 1.0F}, {"pot2", 0.0F}})),
              "dial 0 0.25, dial 1 1.00, dial 2 0.00");
    EXPECT_EQ(wordsOf(boardWith("Encoder", {{"rotation", 5500.0F}})), "1.25 turns 5500\u00a0ticks");
    EXPECT_EQ(wordsOf(boardWith("RFID", {{"id", std::uint32_t{77}}, {"detect_tag", false}})),
              "nothing near the reader no tag");
    EXPECT_EQ(wordsOf(boardWith("RFID", {{"id", std::uint32_t{0x0102}}, {"detect_tag", true}})),
              "tag 258, 0x00000102");
}

TEST(BoardCardTest, ActorsSayWhatTheyDo) {
    const CardContent servos =
        ui::cardOf(boardWith("ServoControl", {{"servo0", -1.0F}, {"servo1", 0.5F}}), kNow);
    EXPECT_NEAR(servos.columns.at(0).at(0).value.value_or(9), 0, 1e-6);
    EXPECT_NEAR(servos.columns.at(1).at(0).value.value_or(9), 0.75, 1e-6);
    const auto flag = [](bool mode, bool blue, bool led) {
        return wordsOf(boardWith("TeamFlag", {{"mode", mode},
                                              {"blue", blue},
                                              {"yellow", false},
                                              {"led1", led},
                                              {"led2", led},
                                              {"led3", false},
                                              {"led4", false}}));
    };
    EXPECT_EQ(flag(true, true, true), "LED 1 LED 2, blue, 2 of 4 lit");
    EXPECT_EQ(flag(false, true, true), "off (blue chosen)");
    EXPECT_EQ(flag(true, false, true), "no colour, 0 of 4 lit");
}

TEST(BoardCardTest, WhatIsNotKnownIsADashAndWhatIsOldIsQuestioned) {
    const DeviceState fresh = boardWith("Encoder", {});
    EXPECT_EQ(wordsOf(fresh), "\u2014 \u2014");
    const DeviceState seen = boardWith("Encoder", {{"rotation", 4400.0F}});
    EXPECT_EQ(wordsOf(seen, kNow + std::chrono::seconds(5)), "1.00 turns? 4400\u00a0ticks?");
}

TEST(BoardCardTest, ABoardOfAUsersCatalogueUnderAKnownNameIsNotTakenForAnother) {
    DeviceState own = boardWith("Encoder", {{"rotation", 4400.0F}});
    DeviceSpec spec = *own.spec;
    spec.parameters[0].name = "angle";
    own.spec = std::make_shared<const DeviceSpec>(spec);
    EXPECT_EQ(wordsOf(own), "angle 4400\u00a0ticks");
}

class BoardCardsTest : public BoardWindow {};

TEST_F(BoardCardsTest, EveryBoardHasACardThatLeadsToItsParameters) {
    connectTo("PolarBear,BatteryBuzzer,LimitSwitch,Unknown");
    for (int i = 0; i < 4; ++i) {
        auto* card = find<ui::DeviceCard>(QStringLiteral("card%1").arg(i));
        ASSERT_TRUE(waitFor([&] { return card->accessibleName().contains(QStringLiteral("live")); }));
        EXPECT_FALSE(card->content().columns.empty());
        EXPECT_TRUE(card->isVisible());
    }
    simulate("switches", 2, 2);
    ASSERT_TRUE(waitFor([&] {
        return std::ranges::any_of(window->findChildren<ui::DeviceCard*>(), [](const ui::DeviceCard* card) {
            return card->accessibleName().contains(QStringLiteral("1 closed"));
        });
    }));
    const int last = 3;
    click(QStringLiteral("card%1").arg(last));
    const QString kind = QString::fromStdString(device(last).spec->name);
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("boardKind")).startsWith(kind); }));
    // Those of another session are gone with it.
    bench->disconnectAll();
    ASSERT_TRUE(waitFor([&] { return window->findChildren<ui::DeviceCard*>().isEmpty(); }));
}

TEST_F(BoardCardsTest, SixBoardsAreSeenWholeInTheUsualWindow) {
    size = {1440, 900};
    connectTo("PolarBear,BatteryBuzzer,LimitSwitch,LineFollower,ServoControl,TeamFlag");
    ASSERT_TRUE(waitFor([&] {
        const auto cards = window->findChildren<ui::DeviceCard*>();
        return cards.size() == 6 && std::ranges::all_of(cards, [](const ui::DeviceCard* card) {
                   return card->visibleRegion().boundingRect() == card->rect();
               });
    }));
}

TEST_F(BoardCardsTest, AnyParametersOfAnyBoardsArePlottedTogether) {
    connectTo("PolarBear,BatteryBuzzer");
    auto* tree = find<ui::PlotChoice>(QStringLiteral("boardPlotTree"));
    auto* plot = find<ui::TimePlot>(QStringLiteral("boardPlot"));
    ASSERT_TRUE(waitFor([&] { return tree->topLevelItemCount() == 2; }));
    const auto item = [&](const char* board, const char* parameter) -> QTreeWidgetItem* {
        for (int i = 0; i < 2; ++i) {
            QTreeWidgetItem* top = tree->topLevelItem(i);
            for (int k = 0; top->text(0) == QLatin1String(board) && k < top->childCount(); ++k) {
                if (top->child(k)->text(0) == QLatin1String(parameter)) return top->child(k);
            }
        }
        return nullptr;
    };
    ASSERT_NE(item("PolarBear", "motor_current"), nullptr);
    // What can only be written has no curve.
    EXPECT_EQ(item("PolarBear", "pid_pos_kp"), nullptr);
    for (const auto& one : plot->state().curves)
        EXPECT_FALSE(one.name.isEmpty());
    item("PolarBear", "motor_current")->setCheckState(0, Qt::Checked);
    item("BatteryBuzzer", "v_batt")->setCheckState(0, Qt::Checked);
    const auto curve = [&](const char* name) -> const ui::PlotCurve* {
        for (const ui::PlotCurve& one : plot->state().curves) {
            if (one.name == QLatin1String(name)) return &one;
        }
        return nullptr;
    };
    ASSERT_TRUE(waitFor([&] { return curve("PolarBear motor_current") && curve("BatteryBuzzer v_batt"); }));
    EXPECT_NE(curve("PolarBear motor_current")->area, curve("BatteryBuzzer v_batt")->area);
    ASSERT_TRUE(waitFor([&] {
        const auto stats = plot->statsOf(*curve("BatteryBuzzer v_batt"));
        return stats && stats->mean > 11 && stats->mean < 12.6;
    }));
    ASSERT_TRUE(
        waitFor([&] { return item("BatteryBuzzer", "v_batt")->text(1).endsWith(QStringLiteral("V")); }));
    item("BatteryBuzzer", "v_batt")->setCheckState(0, Qt::Unchecked);
    ASSERT_TRUE(waitFor([&] { return curve("BatteryBuzzer v_batt") == nullptr; }));
    click(QStringLiteral("boardPlotPause"));
    EXPECT_FALSE(plot->isFollowing());
    click(QStringLiteral("boardPlotFollow"));
    EXPECT_TRUE(plot->isFollowing());
}

}  // namespace
}  // namespace kickstand::test
