#pragma once

#include <tl/expected.hpp>

#include "core/base/error.h"

namespace kickstand {

/// A value, or the Error that stands in its place. Functions that can fail return one; nothing throws.
template <class T>
using Result = tl::expected<T, Error>;

/// Wraps an Error for return from a function that gives a Result.
inline tl::unexpected<Error> fail(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

/// Short form for an error that needs no more than its kind, its subject and a detail.
inline tl::unexpected<Error> fail(Errc code, std::string subject = {}, std::string detail = {}) {
    Error error;
    error.code = code;
    error.subject = std::move(subject);
    error.detail = std::move(detail);
    return tl::unexpected<Error>(std::move(error));
}

}  // namespace kickstand
