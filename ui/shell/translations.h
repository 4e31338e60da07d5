#pragma once

namespace kickstand::ui {

/// Has the program speak the user's language, where there is a catalogue of it: installed beside the
/// program's share, or in the build. Otherwise it speaks that of its sources. Once, before the first word is
/// shown.
void installTranslations();

}  // namespace kickstand::ui
