#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <sys/stat.h>
#include <unistd.h>

#include "app/kickstand-sim/control_path.h"
#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

constexpr mode_t kOwnerOnly = 0700;

/// A folder that a variable names; empty where it names none.
std::string folderFrom(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value == '/' ? value : "";
}

bool isOwnersAlone(const std::string& folder) {
    struct stat facts = {};
    return ::lstat(folder.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode) && facts.st_uid == ::getuid() &&
           (facts.st_mode & 077) == 0;
}

}  // namespace

ControlPath defaultControlPath() {
    if (const std::string runtime = folderFrom("XDG_RUNTIME_DIR"); !runtime.empty())
        return {runtime + "/kickstand-sim.sock", {}};
    std::string temporary = folderFrom("TMPDIR");
    if (temporary.empty()) temporary = "/tmp";
    const std::string folder = temporary + "/kickstand-sim-" + std::to_string(::getuid());
    return {folder + "/control.sock", folder};
}

ctl::Outcome makeFolder(const ControlPath& where) {
    if (where.folder.empty()) return {};
    const QString shown = printable(where.folder);
    const QString remedy = Words::tr("Name another place with --control PATH.");
    if (::mkdir(where.folder.c_str(), kOwnerOnly) != 0 && errno != EEXIST) {
        auto failure = ctl::failed({.code = Errc::Io});
        failure.value().text = {Words::tr("The folder %1 cannot be made: %2.")
                                    .arg(shown, QString::fromUtf8(std::strerror(errno))),
                                remedy,
                                {}};
        return failure;
    }
    if (isOwnersAlone(where.folder)) return {};
    auto failure = ctl::failed({.code = Errc::PermissionDenied});
    failure.value().text = {Words::tr("The folder %1 is not this user's alone.").arg(shown), remedy, {}};
    return failure;
}

}  // namespace kickstand::sim
