#pragma once

#include <span>

#include "core/base/error.h"

namespace kickstand {

/// The sentences for one kind of error, as fillFacts() takes them; English, in the translation context
/// "Error".
struct ErrorText {
    Errc code = Errc::Io;
    const char* what = "";
    const char* remedy = "";
    const char* remedyCommand = "";  ///< Never translated.
    const char* onlyFor = "";        ///< For an error with this subject alone; empty for any.
};

/// Every sentence there is. Several for the same code stand in order of preference: the first whose facts are
/// all there is the one; the last of them needs none and is for any subject. Any thread.
std::span<const ErrorText> errorTexts();

}  // namespace kickstand
