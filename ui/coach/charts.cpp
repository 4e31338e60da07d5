#include "ui/coach/charts.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/engine/describe_coach.h"

namespace kickstand::ui {

using namespace coach;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Charts)
};

std::vector<ChartTimer> timersOf(const std::vector<RunningTimer>& running, TimePoint now) {
    std::vector<ChartTimer> timers;
    for (const RunningTimer& timer : running) {
        const double left_s = std::max(0.0, seconds(timer.due - now));
        timers.push_back({describe(timer.kind), 1 - left_s / seconds(timer.span), left_s});
    }
    return timers;
}

}  // namespace

Chart coachChart(const Snapshot& snapshot) {
    enum : std::size_t { kStartup, kNotPaired, kAsserting, kPaired, kMutiny };
    const coach::CoachView& view = snapshot.coach;
    const auto in = [&view](CoachState state) { return view.state == state; };
    const bool mutiny = view.mutiny.has_value();
    Chart chart;
    chart.states = {
        {describe(CoachState::Startup), 0, 0, in(CoachState::Startup)},
        {describe(CoachState::NotPaired), 0, 1, in(CoachState::NotPaired)},
        {describe(CoachState::Asserting), 1, 1, in(CoachState::Asserting)},
        {describe(CoachState::Paired), 2, 0, in(CoachState::Paired) && !mutiny},
        {Words::tr("mutiny (paired)"), 3, 0, in(CoachState::Paired) && mutiny},
    };
    chart.arrows = {
        {kStartup, kPaired, Words::tr("the own boat's Result names this COACH")},
        {kStartup, kNotPaired, Words::tr("5 s")},
        {kNotPaired, kAsserting, Words::tr("Pair")},
        {kAsserting, kNotPaired, Words::tr("other COACH, or silence")},
        {kAsserting, kPaired, Words::tr("Result names this COACH")},
        {kPaired, kMutiny, Words::tr("mutiny, or morale −10")},
        {kMutiny, kPaired, Words::tr("morale above −10, or 3 s")},
        {kPaired, kNotPaired, Words::tr("5 s without Update Morale, or Jettison"), true},
        {kMutiny, kNotPaired, Words::tr("the same"), true},
    };
    chart.timers = timersOf(view.timers, snapshot.time);
    chart.timersColumn = 2.15;
    chart.timersEnd = 3.05;
    return chart;
}

Chart towrpChart(const Snapshot& snapshot) {
    enum : std::size_t { kNotPaired, kPaired, kMutiny };
    const TowrpView& view = snapshot.towrp;
    const auto in = [&view](TowrpState state) { return view.state == state; };
    Chart chart;
    chart.states = {
        {describe(TowrpState::NotPaired), 0, 0, in(TowrpState::NotPaired)},
        {view.stoppedItself ? Words::tr("paired, stands still") : describe(TowrpState::Paired), 1, 0,
         in(TowrpState::Paired)},
        {describe(TowrpState::Mutiny), 2, 0, in(TowrpState::Mutiny)},
    };
    chart.arrows = {
        {kNotPaired, kPaired, Words::tr("Assertion of Command")},
        {kPaired, kNotPaired, Words::tr("5 s without velocity, or Jettison")},
        {kPaired, kMutiny, Words::tr("morale −10")},
        {kMutiny, kPaired, Words::tr("Suppress Mutiny: morale −5")},
        {kMutiny, kNotPaired, Words::tr("3 s without Suppress Mutiny, 5 s without velocity, or Jettison"),
         true},
    };
    chart.timers = timersOf(view.timers, snapshot.time);
    chart.timersColumn = 0.9;
    chart.timersEnd = 2;
    return chart;
}

}  // namespace kickstand::ui
