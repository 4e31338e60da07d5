#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QString>
#include <array>
#include <optional>

#include "core/base/bytes.h"
#include "core/thunderbots/flash_plan.h"
#include "core/thunderbots/image/image_file.h"

namespace kickstand::ui {

/// A firmware file that a person chose: what it is, or why it cannot be used.
struct FlashFile {
    using Plan = thunderbots::image::ImageResult<thunderbots::SharedFlashPlan>;

    QString path;
    QString name;
    QString unreadable;                                   ///< The system's word where it could not be read.
    std::optional<thunderbots::image::ImageError> fault;  ///< Why it gives no image for any target.
    thunderbots::image::ImageFormat format = thunderbots::image::ImageFormat::Binary;
    thunderbots::image::TargetGuess guess;
    thunderbots::image::BitHeader header;
    /// Who it is for: the guess, until a person says otherwise.
    thunderbots::image::FlashTarget target = thunderbots::image::FlashTarget::Microcontroller;
    std::array<Plan, 2> plans;  ///< For each target.

    /// Whether its bytes are an image at all, so that a target can be chosen.
    bool isImage() const { return unreadable.isEmpty() && !fault; }
    /// What it comes to for its target; null where that is refused.
    thunderbots::SharedFlashPlan plan() const;
    /// Why it cannot be for its target, or is no image.
    std::optional<thunderbots::image::ImageError> refusal() const;
    /// Whether there is nothing in it but erased bytes.
    bool isBlank() const { return plan() && plan()->pages().empty(); }
};

/// Makes of a file's contents what there is to know of it, for both targets. Takes some tens of milliseconds
/// for a large file. Any thread.
FlashFile makeFlashFile(const QString& path, ByteView contents);
/// Reads it first; never more than a firmware file can have. Any thread.
FlashFile readFlashFile(const QString& path);

/// Reads firmware files on threads of their own, so that a slow disk or a large file does not hold up the
/// window. GUI thread.
class FlashReader final : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    void read(const QString& path);
    /// How many are being read.
    int pending() const { return pending_; }

  signals:
    void finished(const kickstand::ui::FlashFile& file);

  private:
    int pending_ = 0;
};

}  // namespace kickstand::ui
