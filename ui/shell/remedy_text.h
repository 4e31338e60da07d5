#pragma once

#include <QString>

namespace kickstand {
struct Description;
}

namespace kickstand::ui {

/// What to do about it, where a button beside the words copies the command that does it.
QString remedyBesideCopy(const Description& words);

}  // namespace kickstand::ui
