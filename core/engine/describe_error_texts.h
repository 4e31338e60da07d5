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
};

/// Every sentence there is. Several for the same code stand in order of preference: the first whose facts are
/// all there is the one; the last of them needs none. Any thread.
std::span<const ErrorText> errorTexts();

}  // namespace kickstand
