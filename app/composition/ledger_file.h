#pragma once

#include <string>

namespace kickstand {

/// Where the fleet's history is kept: the file that KICKSTAND_LEDGER names, else fleet.sqlite in this user's
/// data folder, which is made. ":memory:" where there is no such place: nothing is kept then.
std::string ledgerFile();

}  // namespace kickstand
