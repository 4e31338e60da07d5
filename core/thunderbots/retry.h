#pragma once

namespace kickstand::thunderbots {

/// How often in a row a stalled endpoint is cleared and tried again before the connection is given up
/// (protocol 3.4).
constexpr int kStallRetries = 5;

}  // namespace kickstand::thunderbots
