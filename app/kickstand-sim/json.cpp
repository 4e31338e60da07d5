#include "app/kickstand-sim/json.h"

#include <QJsonDocument>
#include <algorithm>
#include <array>
#include <cmath>

namespace kickstand::sim {
namespace {

/// What only a mistake on the command line leads to.
constexpr std::array kUsageCodes{Errc::BadArgument, Errc::OutOfRange, Errc::UnknownName, Errc::Malformed};

bool isUsage(const QString& code) {
    return code == QLatin1String("usage") ||
           std::ranges::any_of(kUsageCodes, [&](Errc known) { return code == QLatin1String(name(known)); });
}

}  // namespace

double rounded(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return std::round(value * scale) / scale;
}

QJsonObject toJson(const ctl::Failure& failure) {
    return {{QStringLiteral("ok"), false},
            {QStringLiteral("error"), QJsonObject{{QStringLiteral("code"), failure.code},
                                                  {QStringLiteral("what"), failure.text.what},
                                                  {QStringLiteral("remedy"), failure.text.remedy}}}};
}

ctl::Failure failureFrom(const QJsonObject& answer) {
    const QJsonObject error = answer[QStringLiteral("error")].toObject();
    ctl::Failure failure;
    failure.code = error[QStringLiteral("code")].toString();
    failure.exitCode = isUsage(failure.code) ? ctl::kBadUsage : ctl::kFailed;
    failure.text.what = error[QStringLiteral("what")].toString();
    failure.text.remedy = error[QStringLiteral("remedy")].toString();
    return failure;
}

QByteArray compact(const QJsonObject& json) {
    return QJsonDocument(json).toJson(QJsonDocument::Compact);
}

}  // namespace kickstand::sim
