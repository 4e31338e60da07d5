#include "app/kickstandctl/failure.h"

namespace kickstand::ctl {
namespace {

tl::unexpected<Failure> fromError(const Error& error, ExitCode exitCode) {
    return tl::unexpected<Failure>({exitCode, describe(error), QString::fromLatin1(name(error.code))});
}

}  // namespace

tl::unexpected<Failure> badUsage(const QString& what, const QString& remedy) {
    return tl::unexpected<Failure>({kBadUsage, {what, remedy, {}}, QStringLiteral("usage")});
}

tl::unexpected<Failure> failed(const Error& error) {
    return fromError(error, kFailed);
}

tl::unexpected<Failure> refusedInput(const Error& error) {
    return fromError(error, kBadUsage);
}

}  // namespace kickstand::ctl
