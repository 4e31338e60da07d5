#pragma once

#include <string>

#include "app/kickstandctl/failure.h"

namespace kickstand::sim {

/// Where the control socket is unless somebody says otherwise: in $XDG_RUNTIME_DIR, else in a folder of this
/// user alone under the temporary one.
struct ControlPath {
    std::string path;
    std::string folder;  ///< To be made by makeFolder(); empty where it is there already.
};
ControlPath defaultControlPath();

/// Makes the folder, or sees that the one that is there is this user's and closed to all others.
ctl::Outcome makeFolder(const ControlPath& where);

}  // namespace kickstand::sim
