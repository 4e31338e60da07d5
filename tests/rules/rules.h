#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tests/rules/tree.h"

namespace kickstand::rules {

/// One place where a rule is broken.
struct Violation {
    std::string path;
    std::size_t line = 1;   ///< From 1.
    std::string_view rule;  ///< One of kRules.
    std::string message;
};

// The rules, by the names that a violation carries.
inline constexpr std::string_view kLayer = "layer";      ///< Who may include whom.
inline constexpr std::string_view kLibrary = "library";  ///< One folder for each outside library.
inline constexpr std::string_view kPure = "pure";  ///< wire/, image/ and framing/: the standard library only.
inline constexpr std::string_view kCoreQt = "core-qt";            ///< No Qt in core, but in the named places.
inline constexpr std::string_view kIncludePath = "include-path";  ///< Include paths start at the root.
inline constexpr std::string_view kPragmaOnce = "pragma-once";
inline constexpr std::string_view kForeignSource =
    "foreign-source";                                          ///< No target lists another folder's sources.
inline constexpr std::string_view kBudget = "budget";          ///< Lines in a file.
inline constexpr std::string_view kReadme = "readme";          ///< Every top folder says what it is.
inline constexpr std::string_view kUnfinished = "unfinished";  ///< No notes to do something later.
inline constexpr std::string_view kMachinePath = "machine-path";  ///< No absolute path of somebody's machine.

inline constexpr std::string_view kUntranslated =
    "untranslated";  ///< What the window shows goes through tr().

inline constexpr std::string_view kRules[] = {kLayer,       kLibrary,    kPure,          kCoreQt,
                                              kIncludePath, kPragmaOnce, kForeignSource, kBudget,
                                              kReadme,      kUnfinished, kMachinePath,   kUntranslated};

/// The rules about includes: layer, library, pure, core-qt, include-path, pragma-once.
std::vector<Violation> checkIncludes(const Tree& tree);

/// The rules about the files themselves: foreign-source, budget, readme, unfinished, machine-path,
/// untranslated; core-qt in CMake's files.
std::vector<Violation> checkTexts(const Tree& tree);

}  // namespace kickstand::rules
