#include "core/engine/link_provider.h"

namespace kickstand {

Result<ProvidedByteLink> LinkProvider::makeByteLink(const LinkUri& uri, Scheduler& /*scheduler*/) {
    return fail(Errc::Unsupported, toString(uri), "no serial lines here");
}

Result<ProvidedBytePorts> LinkProvider::makeBytePorts(const LinkUri& uri, Scheduler& /*scheduler*/) {
    return fail(Errc::Unsupported, toString(uri), "no serial lines here");
}

}  // namespace kickstand
