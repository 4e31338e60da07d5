#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::ctl {
namespace {

Outcome devices(const Context& context) {
    SessionRunner runner(context);
    const auto found = runner.discover();
    if (!found) return tl::unexpected(found.error());

    QJsonArray json;
    QList<QStringList> rows;
    for (const FoundDevice& device : *found) {
        json.append(toJson(device));
        rows.append({QString::fromStdString(toString(device.uri)), printable(device.info.productName),
                     Words::tr("at %1").arg(printable(device.info.port)),
                     device.obstacle ? describe(*device.obstacle).line() : Words::tr("ready")});
    }
    context.output.value(json);
    if (found->empty())
        context.output.line(
            Words::tr("No dongle or cabled robot is plugged in. Simulated ones: --link sim:thunderbots."));
    context.output.table(rows);
    return {};
}

constexpr CommandSpec kCommands[] = {
    {"devices",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl", "Lists the dongles and cabled robots that are plugged in."),
     QT_TRANSLATE_NOOP("kickstandctl", "Each with its link, and what stands in the way of using it."),
     {},
     "devices --json",
     devices},
};

}  // namespace

std::span<const CommandSpec> deviceCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
