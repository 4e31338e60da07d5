#pragma once

#include <QString>

#include "core/thunderbots/wire/faults.h"

namespace kickstand {

/// What a fault code says, without what it is about: "Message could not be sent". Translatable. Any thread
/// once the application object exists.
QString faultMeaning(const thunderbots::wire::Fault& fault);
/// The same with its subject: "Robot 7: Message could not be sent", or "Unknown fault code 200". As
/// faultMeaning().
QString faultText(const thunderbots::wire::Fault& fault);

}  // namespace kickstand
