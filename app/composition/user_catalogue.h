#pragma once

#include <string>

namespace kickstand {

/// The user's own catalogue of smart devices.
struct UserCatalogue {
    std::string text;    ///< Empty where there is no such file.
    std::string source;  ///< The file.
};

/// Reads the file that KICKSTAND_DEVICES names, else devices.json in this user's data folder. A file that is
/// longer than a catalogue can be is read no further than that, and so refused. Blocks for a moment.
UserCatalogue readUserCatalogue();

}  // namespace kickstand
