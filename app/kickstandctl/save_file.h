#pragma once

#include <QByteArray>
#include <QString>

#include "app/kickstandctl/failure.h"

namespace kickstand::ctl {

/// Writes a file whole or not at all: what stood there before stays when it fails, with exit 1.
Outcome saveFile(const QString& path, const QByteArray& content);

}  // namespace kickstand::ctl
