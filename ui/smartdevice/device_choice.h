#pragma once

#include <QObject>
#include <QString>
#include <map>

#include "core/smartdevice/snapshot.h"

class QSettings;

namespace kickstand::ui {

/// Which board the panels are about. GUI thread.
class DeviceChoice final : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;

    /// The number of the chosen board; -1 while there is none.
    int chosen() const { return chosen_; }
    void choose(int device);
    /// Takes what there is: where nothing is chosen that is there, the first board is.
    void follow(const smartdevice::Snapshot* snapshot);
    /// The chosen board of a snapshot; null where there is none.
    const smartdevice::DeviceState* deviceOf(const smartdevice::Snapshot* snapshot) const;

    /// The simulator's number of the chosen board; -1 where it has none.
    int chosenUnit() const;
    /// The kind of the board that has this number in the simulator; empty while nobody knows.
    QString kindOfUnit(int unit) const;

  signals:
    void changed();

  private:
    int chosen_ = -1;
    std::map<int, int> units_;  ///< Of the simulator, by the boards' numbers.
    std::map<int, QString> kinds_;
};

/// The name that a person gave a board, kept by its UID; empty where it has none.
QString ownNameOf(const QSettings& settings, const smartdevice::DeviceState& device);
/// Gives it one, or takes it away with an empty one.
void setOwnName(QSettings& settings, const smartdevice::DeviceState& device, const QString& name);
/// What a board is called: its own name, or its kind.
QString titleOf(const QSettings& settings, const smartdevice::DeviceState& device);

}  // namespace kickstand::ui
