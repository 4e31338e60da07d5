#include "tests/rules/tree.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace kickstand::rules {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 14> kTextEndings{".cpp",   ".h",    ".txt",  ".cmake", ".md",
                                                        ".sh",    ".json", ".xml",  ".qrc",   ".desktop",
                                                        ".rules", ".svg",  ".supp", ".1"};

bool isText(const std::string& path) {
    return std::ranges::any_of(kTextEndings, [&](std::string_view ending) { return path.ends_with(ending); });
}

bool isLeftOut(const std::string& path) {
    return path.starts_with(".") || path == "build" || path == "tests/data";
}

SourceFile readFile(const fs::path& file, std::string path) {
    SourceFile source{std::move(path), {}};
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        source.lines.push_back(std::move(line));
    return source;
}

}  // namespace

Tree loadTree(const fs::path& root) {
    Tree tree;
    std::error_code error;
    fs::recursive_directory_iterator entries(root, error);
    for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
        std::string path = entries->path().lexically_relative(root).generic_string();
        if (entries->is_directory() && isLeftOut(path)) {
            entries.disable_recursion_pending();
        } else if (entries->is_regular_file() && isText(path)) {
            tree.files.push_back(readFile(entries->path(), std::move(path)));
        }
    }
    std::ranges::sort(tree.files, {}, &SourceFile::path);
    return tree;
}

}  // namespace kickstand::rules
