#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kickstand::rules {

/// One text file of the repository.
struct SourceFile {
    std::string path;  ///< From the root, with forward slashes.
    std::vector<std::string> lines;

    bool isHeader() const { return path.ends_with(".h"); }
    bool isSource() const { return path.ends_with(".cpp"); }
    bool isCode() const { return isHeader() || isSource(); }
    bool isCMake() const { return path.ends_with("CMakeLists.txt") || path.ends_with(".cmake"); }
    /// Whether it lies in a folder, given with its closing slash.
    bool isIn(std::string_view folder) const { return path.starts_with(folder); }
};

/// The text files that the rules speak about.
struct Tree {
    std::vector<SourceFile> files;  ///< Sorted by path.
};

/// Reads the text files below `root`. Leaves out builds, what version control keeps for itself, and
/// tests/data, whose fixtures are broken on purpose.
Tree loadTree(const std::filesystem::path& root);

}  // namespace kickstand::rules
