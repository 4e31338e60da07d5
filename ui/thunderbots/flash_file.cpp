#include "ui/thunderbots/flash_file.h"

#include <QFile>
#include <QFileInfo>
#include <QPromise>
#include <QThreadPool>
#include <memory>
#include <utility>

namespace kickstand::ui {

using namespace thunderbots;
using image::FlashTarget;

namespace {

FlashFile::Plan planFor(const image::FlashImage& image, FlashTarget target) {
    auto settled = image::forTarget(image, target);
    if (!settled) return tl::unexpected(settled.error());
    return std::make_shared<const FlashPlan>(*std::move(settled));
}

}  // namespace

SharedFlashPlan FlashFile::plan() const {
    const Plan& plan = plans[static_cast<std::size_t>(target)];
    return isImage() && plan ? *plan : nullptr;
}

std::optional<image::ImageError> FlashFile::refusal() const {
    if (fault) return fault;
    const Plan& plan = plans[static_cast<std::size_t>(target)];
    return plan ? std::nullopt : std::optional(plan.error());
}

FlashFile makeFlashFile(const QString& path, ByteView contents) {
    FlashFile file;
    file.path = path;
    file.name = QFileInfo(path).fileName();
    const auto image = image::readImage(file.name.toStdString(), contents);
    if (!image) {
        file.fault = image.error();
        return file;
    }
    file.format = image->format;
    file.guess = image->guess;
    file.header = image->header;
    file.target = image->target;
    for (const FlashTarget target : {FlashTarget::Microcontroller, FlashTarget::Fpga})
        file.plans[static_cast<std::size_t>(target)] = planFor(*image, target);
    return file;
}

FlashFile readFlashFile(const QString& path) {
    QFile source(path);
    QByteArray contents;
    // A byte more tells that it is too long, and nothing longer is ever held.
    if (source.open(QIODevice::ReadOnly)) contents = source.read(image::kLargestFile + 1);
    if (source.error() == QFileDevice::NoError) {
        return makeFlashFile(path, ByteView(reinterpret_cast<const std::uint8_t*>(contents.constData()),
                                            static_cast<std::size_t>(contents.size())));
    }
    FlashFile file;
    file.path = path;
    file.name = QFileInfo(path).fileName();
    file.unreadable = source.errorString();
    return file;
}

void FlashReader::read(const QString& path) {
    ++pending_;
    auto promise = std::make_shared<QPromise<FlashFile>>();
    auto* watcher = new QFutureWatcher<FlashFile>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] {
        --pending_;
        watcher->deleteLater();
        emit finished(watcher->result());
    });
    watcher->setFuture(promise->future());
    promise->start();
    QThreadPool::globalInstance()->start([promise, path] {
        promise->addResult(readFlashFile(path));
        promise->finish();
    });
}

}  // namespace kickstand::ui
