#include "app/kickstandctl/plan_options.h"

#include <QFile>

#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"
#include "core/motionplan/wire/plan_text.h"

namespace kickstand::ctl {
namespace {

namespace wire = motionplan::wire;

Expected<std::string> readText(const Invocation& invocation) {
    if (!invocation.has("--file")) {
        std::string text;
        for (const std::string& operand : invocation.operands)
            text += (text.empty() ? "" : " ") + operand;
        return text;
    }
    const QString name = printable(std::string(invocation.text("--file")));
    if (!invocation.operands.empty())
        return badUsage(Words::tr("The plan is given twice."), Words::tr("Give it as text or by --file."));
    QFile file(QString::fromStdString(std::string(invocation.text("--file"))));
    if (!file.open(QIODevice::ReadOnly))
        return badUsage(Words::tr("%1 cannot be read: %2.").arg(name, file.errorString()),
                        Words::tr("Name a file with a plan, such as one that the window has saved."));
    // One byte more shows that there is too much.
    return file.read(wire::kMostPlanTextBytes + 1).toStdString();
}

}  // namespace

Expected<int> readSlot(const Invocation& invocation) {
    return parseWhole(invocation.text("--slot"), "--slot", 0, wire::kSlots - 1);
}

Expected<std::optional<int>> readPlanId(const Invocation& invocation) {
    if (!invocation.has("--plan")) return std::nullopt;
    const auto id = parseWhole(invocation.text("--plan"), "--plan", wire::kFirstPlan, wire::kLastPlan);
    if (!id) return tl::unexpected(id.error());
    return *id;
}

Expected<std::optional<std::vector<motionplan::Movement>>> readPlan(const Invocation& invocation,
                                                                    motionplan::PlanUse use) {
    if (!invocation.has("--file") && invocation.operands.empty()) return std::nullopt;
    const auto text = readText(invocation);
    if (!text) return tl::unexpected(text.error());
    auto movements = wire::parsePlanText(*text);
    if (!movements) return refusedInput(movements.error());
    if (const auto bytes = motionplan::planBytes(*movements, use); !bytes) return refusedInput(bytes.error());
    return *std::move(movements);
}

Expected<SpeedChange> readSpeedChange(const Invocation& invocation) {
    SpeedChange change;
    const std::string_view wheels = invocation.text("--wheels");
    if (wheels == "left")
        change.wheels = motionplan::Wheels::LeftForward;
    else if (wheels == "right")
        change.wheels = motionplan::Wheels::RightForward;
    else if (wheels != "both")
        return badUsage(Words::tr("--wheels is “%1”.").arg(printable(std::string(wheels))),
                        Words::tr("One of: both, left, right."));
    const auto percent = parseWhole(invocation.text("--change"), "--change", -wire::kMostChange_percent,
                                    wire::kMostChange_percent);
    if (!percent) return tl::unexpected(percent.error());
    change.change_percent = *percent;
    return change;
}

}  // namespace kickstand::ctl
