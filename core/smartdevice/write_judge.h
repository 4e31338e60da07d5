#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/base/session_host.h"
#include "core/base/time.h"
#include "core/smartdevice/snapshot.h"

namespace kickstand::smartdevice {

/// Decides what became of writes. A device answers a write with Data of the parameters that it took, but Data
/// does not say what it answers, and samples of a subscription that were on their way may still show the old
/// value: so it is judged after the answer and one more sample, or after 250 ms. Several may be in flight.
class WriteJudge {
  public:
    /// What one parameter came to.
    struct Judgement {
        int parameter = 0;
        WriteVerdict verdict = WriteVerdict::Done;
    };
    /// A write that has been judged to its end.
    struct Ended {
        CommandId id = 0;
        int firstRefused = -1;  ///< A parameter that was refused, or less than 0.
        int firstSilent = -1;   ///< A parameter of which nothing came at all, or less than 0.
    };

    /// A write was sent: `values` of what can be read again; `parameters` as they were before.
    void begin(CommandId id, std::map<int, wire::Value> values, const std::vector<ParameterState>& parameters,
               TimePoint now);
    /// What Data may be to a write.
    enum class Role {
        Answer,     ///< Perhaps its answer.
        SampleEnd,  ///< With it, a whole sample has come.
        Other,
    };
    /// Data came and `parameters` have its values.
    void data(wire::ParameterMask mask, Role role, const std::vector<ParameterState>& parameters);
    /// Judges what is due.
    void step(TimePoint now);
    /// Gives up all of them; their ids.
    std::vector<CommandId> abandon();

    std::vector<Judgement> takeJudgements() { return std::exchange(judgements_, {}); }
    std::vector<Ended> takeEnded() { return std::exchange(ended_, {}); }

  private:
    struct Flight {
        CommandId id = 0;
        std::map<int, wire::Value> open;  ///< Not judged yet.
        std::map<int, std::optional<wire::Value>> before;
        std::map<int, wire::Value> last;  ///< What came of them since.
        wire::ParameterMask mask = 0;
        wire::ParameterMask answered = 0;  ///< What the answer had in it.
        bool hasAnswer = false;
        TimePoint deadline{};
        Ended end;
    };

    static WriteVerdict verdictOf(const Flight& flight, int parameter);
    void note(Flight& flight, int parameter, WriteVerdict verdict);
    void take(Flight& flight, wire::ParameterMask mask, const std::vector<ParameterState>& parameters);
    void judgeRest(Flight& flight);
    void removeEnded();

    std::vector<Flight> flights_;
    std::vector<Judgement> judgements_;
    std::vector<Ended> ended_;
};

}  // namespace kickstand::smartdevice
