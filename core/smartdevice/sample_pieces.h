#pragma once

#include <vector>

#include "core/smartdevice/wire/message.h"

namespace kickstand::smartdevice {

/// Tells the samples of a subscription from answers. A device may send a sample in several Data messages
/// (protocol 3): it does so in the same way every time, which is learnt from what comes.
class SamplePieces {
  public:
    /// What a Data message is of a sample.
    enum class Part {
        None,  ///< It is none; it answers something.
        Piece,
        End,  ///< It is the last piece, or all of it.
    };

    /// A subscription begins, or there is none any more.
    void restart(wire::ParameterMask subscribed, bool sends);
    /// Data of these parameters came.
    Part take(wire::ParameterMask mask);

  private:
    void learn(wire::ParameterMask mask);

    wire::ParameterMask subscribed_ = 0;
    bool sends_ = false;
    std::vector<wire::ParameterMask> pieces_;  ///< As a sample was cut last.
    std::vector<wire::ParameterMask> run_;     ///< Messages in a row that may become one.
    wire::ParameterMask seen_ = 0;             ///< Of the sample that is coming.
};

}  // namespace kickstand::smartdevice
