#pragma once

#include <QListWidget>
#include <vector>

#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

/// One line of the list: a board, or a port at which there is none.
struct DeviceLine {
    int device = -1;  ///< The board's number; -1 for a port.
    QString kind;     ///< Of the board; empty for a port.
    QString title;
    QString place;  ///< "PolarBear · /dev/ttyACM0".
    QString median;
    QString p99;
    Standing standing;
    QString remedy;  ///< What is to be done about a port.

    friend bool operator==(const DeviceLine&, const DeviceLine&) = default;
};

/// Boards, each with its picture, what it is called and what it is, where it is, how long it takes to answer
/// and how it stands; then the ports without one. It shows what it is told; `asked` is what a person wants.
class DeviceList final : public QListWidget {
    Q_OBJECT
  public:
    explicit DeviceList(QWidget* parent = nullptr);

    void setLines(std::vector<DeviceLine> lines);
    /// Marks the line of a board.
    void setChosen(int device);
    /// The line that is current; null where there is none.
    const DeviceLine* currentLine() const;
    const std::vector<DeviceLine>& lines() const { return lines_; }

  signals:
    void asked(int device);
    void currentLineChanged();

  private:
    std::vector<DeviceLine> lines_;
    int chosen_ = -1;
};

}  // namespace kickstand::ui
