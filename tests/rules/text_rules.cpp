#include <algorithm>
#include <array>
#include <cctype>
#include <functional>

#include "tests/rules/rules.h"

namespace kickstand::rules {
namespace {

/// How long files may be: none past `most`, and nine in ten no longer than `usual`.
struct Budget {
    std::size_t usual;
    std::size_t most;
    const char* what;
};
constexpr Budget kSourceBudget{449, 800, "sources"};
constexpr Budget kHeaderBudget{110, 250, "headers"};

// Written in halves so that this file keeps its own rules.
const std::array<std::string, 3> kUnfinishedMarks{std::string("TO") + "DO", std::string("FIX") + "ME",
                                                  std::string("X") + "XX"};
const std::array<std::string, 5> kMachineFolders{std::string("/ho") + "me/", std::string("/ro") + "ot/",
                                                 std::string("/wo") + "rk/", std::string("/Us") + "ers/",
                                                 std::string("C:\\Us") + "ers\\"};
constexpr std::array<std::string_view, 6> kTopFolders{"app/",       "core/",  "packaging/",
                                                      "resources/", "tests/", "ui/"};
constexpr std::array<std::string_view, 3> kCoreQtModules{"Core", "SerialPort", "Sql"};

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Whether `word` stands in the line, not as a part of a longer word.
bool hasWord(std::string_view line, std::string_view word) {
    for (std::size_t at = line.find(word); at != line.npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isWord(line[at - 1])) && (end == line.size() || !isWord(line[end]))) return true;
    }
    return false;
}

/// Whether an absolute path begins in the line with `folder`; the middle of a longer path or address does not
/// count.
bool hasAbsolutePath(std::string_view line, std::string_view folder) {
    constexpr std::string_view kPathCharacters = ".-~}*";
    for (std::size_t at = line.find(folder); at != line.npos; at = line.find(folder, at + 1)) {
        const char before = at == 0 ? ' ' : line[at - 1];
        if (!isWord(before) && kPathCharacters.find(before) == kPathCharacters.npos) return true;
    }
    return false;
}

/// The calls by which words get onto the screen.
constexpr std::array<std::string_view, 14> kShowing{
    "setText(",      "setToolTip(", "setWindowTitle(", "setAccessibleName(", "setPlaceholderText(",
    "setWhatsThis(", "addAction(",  "addMenu(",        "addSection(",        "addTab(",
    "QPushButton(",  "QLabel(",     "QCheckBox(",      "QMessageBox("};

/// Whether a text that begins here is a literal of more than one letter, whatever makes a QString of it.
bool isWordsLiteral(std::string_view text) {
    for (const std::string_view maker : {"QStringLiteral(", "QLatin1String(", "u"}) {
        if (text.starts_with(maker)) text.remove_prefix(maker.size());
    }
    if (!text.starts_with('"')) return false;
    text = text.substr(1, text.find('"', 1) - 1);
    const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    return std::ranges::count_if(text, isLetter) > 1;
}

void checkTranslated(const SourceFile& file, std::vector<Violation>& found) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        const std::string_view line = file.lines[i];
        for (const std::string_view call : kShowing) {
            const std::size_t at = line.find(call);
            if (at != line.npos && isWordsLiteral(line.substr(at + call.size()))) {
                found.push_back(
                    {file.path, i + 1, kUntranslated, "words without tr(): " + std::string(line.substr(at))});
            }
        }
    }
}

void checkLines(const SourceFile& file, std::vector<Violation>& found) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        for (const std::string& mark : kUnfinishedMarks) {
            if (hasWord(file.lines[i], mark))
                found.push_back({file.path, i + 1, kUnfinished, "unfinished: " + mark});
        }
        for (const std::string& folder : kMachineFolders) {
            if (hasAbsolutePath(file.lines[i], folder)) {
                found.push_back(
                    {file.path, i + 1, kMachinePath, "an absolute path of one machine: " + folder});
            }
        }
    }
}

/// Calls `use` with each word of a CMake line, its comment left out.
void eachCMakeWord(std::string_view line, const std::function<void(std::string_view)>& use) {
    constexpr std::string_view kSeparators = " \t()\";";
    line = line.substr(0, line.find('#'));
    while (!line.empty()) {
        const std::size_t end = std::min(line.find_first_of(kSeparators), line.size());
        if (end > 0) use(line.substr(0, end));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
}

void checkCMake(const SourceFile& file, std::vector<Violation>& found) {
    constexpr std::string_view kQt = "Qt6::";
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        eachCMakeWord(file.lines[i], [&](std::string_view word) {
            const bool outside = word.find("..") != word.npos || word.find("SOURCE_DIR}/") != word.npos;
            if (word.ends_with(".cpp") && outside) {
                found.push_back(
                    {file.path, i + 1, kForeignSource, "a source of another folder: " + std::string(word)});
            }
            if (file.isIn("core/") && word.starts_with(kQt) &&
                std::ranges::find(kCoreQtModules, word.substr(kQt.size())) == kCoreQtModules.end()) {
                found.push_back({file.path, i + 1, kCoreQt, "core may not link " + std::string(word)});
            }
        });
    }
}

std::string overBudget(const SourceFile& file, std::size_t limit, std::string_view why) {
    return std::to_string(file.lines.size()) + " lines, over " + std::to_string(limit) + std::string(why);
}

/// The files past the hard limit, and all past the usual one where they are more than one in ten.
void checkBudget(const std::vector<const SourceFile*>& files, const Budget& budget,
                 std::vector<Violation>& found) {
    std::vector<const SourceFile*> unusual;
    for (const SourceFile* file : files) {
        if (file->lines.size() > budget.most) {
            found.push_back({file->path, budget.most + 1, kBudget,
                             overBudget(*file, budget.most, ", the most there is")});
        } else if (file->lines.size() > budget.usual) {
            unusual.push_back(file);
        }
    }
    if (unusual.size() * 10 <= files.size()) return;
    for (const SourceFile* file : unusual) {
        found.push_back(
            {file->path, budget.usual + 1, kBudget,
             overBudget(*file, budget.usual, std::string(", like more than one in ten ") + budget.what)});
    }
}

void checkBudgets(const Tree& tree, std::vector<Violation>& found) {
    std::vector<const SourceFile*> sources;
    std::vector<const SourceFile*> headers;
    for (const SourceFile& file : tree.files) {
        if (file.isSource()) sources.push_back(&file);
        if (file.isHeader()) headers.push_back(&file);
    }
    checkBudget(sources, kSourceBudget, found);
    checkBudget(headers, kHeaderBudget, found);
}

void checkReadmes(const Tree& tree, std::vector<Violation>& found) {
    for (const std::string_view folder : kTopFolders) {
        const std::string readme = std::string(folder) + "README.md";
        const auto isInFolder = [&](const SourceFile& file) { return file.isIn(folder); };
        if (std::ranges::any_of(tree.files, isInFolder) &&
            std::ranges::find(tree.files, readme, &SourceFile::path) == tree.files.end()) {
            found.push_back({readme, 1, kReadme,
                             "missing: what is in this folder, what may not be, where to start reading"});
        }
    }
}

}  // namespace

std::vector<Violation> checkTexts(const Tree& tree) {
    std::vector<Violation> found;
    for (const SourceFile& file : tree.files) {
        checkLines(file, found);
        if (file.isCMake()) checkCMake(file, found);
        if (file.isIn("ui/") && file.isSource()) checkTranslated(file, found);
    }
    checkBudgets(tree, found);
    checkReadmes(tree, found);
    return found;
}

}  // namespace kickstand::rules
