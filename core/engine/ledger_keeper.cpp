#include "core/engine/ledger_keeper.h"

#include <utility>

#include "core/base/hex.h"

namespace kickstand {
namespace {

using thunderbots::EventKind;

std::uint16_t signatureOf(std::int64_t code) {
    return static_cast<std::uint16_t>(code & 0xFFFF);
}

void keep(Ledger& ledger, const thunderbots::Event& event, const std::string& source,
          std::chrono::system_clock::time_point time) {
    if (event.kind == EventKind::SignaturesRead) {
        ledger.add(
            SignatureRecord{source, event.robot, signatureOf(event.code), signatureOf(event.previous)});
        return;
    }
    if (event.kind != EventKind::ParametersRead) return;
    auto block = parseHex(event.text);
    if (!block) return;
    ParameterRecord record;
    record.time = time;
    record.source = source;
    record.robot = event.robot;
    record.block = *std::move(block);
    ledger.add(std::move(record));
}

/// Nothing of smart devices outlives a session.
void keep(Ledger&, const smartdevice::Event&, const std::string&, std::chrono::system_clock::time_point) {}

/// Nothing of motion plans outlives a session.
void keep(Ledger&, const motionplan::Event&, const std::string&, std::chrono::system_clock::time_point) {}

/// Nor of boats.
void keep(Ledger&, const coach::Event&, const std::string&, std::chrono::system_clock::time_point) {}

}  // namespace

void LedgerKeeper::take(const EngineEvent& event, const std::string& source,
                        std::chrono::system_clock::time_point time) {
    const auto* system = std::get_if<SystemEvent>(&event.body);
    if (system == nullptr) return;
    std::visit([&](const auto& own) { keep(ledger_, own, source, time); }, *system);
}

}  // namespace kickstand
