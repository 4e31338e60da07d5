#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/base/error.h"

namespace kickstand {

// How an Error's facts get into a sentence. Any thread.

/// Text from outside, fit to be shown in one line: control characters, line breaks and what turns the
/// direction of writing become a replacement character, and what is very long is cut.
QString printable(const std::string& text);

/// Puts facts into a sentence. In `text`, {subject}, {detail}, {robot}, {endpoint}, {lowest}, {highest} and
/// {got} stand for the facts of that name, {place} for `got` counted from 1. What stands in [brackets] is
/// left out when one of its facts is missing; nothing comes back when one outside brackets is. Facts are
/// never read as templates themselves.
std::optional<QString> fillFacts(const QString& text, const Error& error);

}  // namespace kickstand
