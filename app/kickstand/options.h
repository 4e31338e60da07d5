#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/link/link_uri.h"
#include "ui/shell/theme.h"

namespace kickstand::app {

/// What the program was asked for on its command line.
struct Options {
    std::vector<LinkUri> links;
    std::optional<QString> tourFolder;
    std::optional<ui::ThemeChoice> theme;
    bool newInstance = false;  ///< Beside a window that is open already.
    bool announce = false;     ///< Tell on standard output how far the start has come.
};

/// Reads the command line. --help and --version end the program here with exit code 0, nonsense with one line
/// on standard error and exit code 2.
Options readOptions(const QStringList& arguments);

}  // namespace kickstand::app
