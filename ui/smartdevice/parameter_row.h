#pragma once

#include <QObject>
#include <optional>

#include "core/smartdevice/snapshot.h"
#include "ui/smartdevice/device_words.h"
#include "ui/smartdevice/parameter_editor.h"

class QCheckBox;
class QGridLayout;
class QLabel;

namespace kickstand::ui {

class StateLabel;

/// One parameter of a board as a line of a table: whether it is sent by itself, its name, its value, what
/// sets it, and what became of the last write. Its widgets belong to the table's.
class ParameterRow final : public QObject {
    Q_OBJECT
  public:
    enum Column { Update, Name, Value, Editor, Verdict, ColumnCount };

    ParameterRow(const smartdevice::ParameterSpec& spec, int number, QGridLayout& grid, QWidget* table);

    /// `waiting`: a write that the engine has not answered is on its way.
    void refresh(const smartdevice::DeviceState& device, TimePoint now, bool blocked, bool waiting);
    /// Says what became of a write that was not judged, and why; until the next one.
    void showFailure(const Error& error);

  signals:
    void writeAsked(int parameter, const kickstand::smartdevice::wire::Value& value);
    void updateAsked(int parameter, bool on);
    void refused(const kickstand::Error& error);

  private:
    void makeName(QGridLayout& grid, QWidget* table);
    void makeValue(QGridLayout& grid, QWidget* table);
    void makeEditor(QGridLayout& grid, QWidget* table);

    const smartdevice::ParameterSpec spec_;
    const int number_;
    QCheckBox* update_;
    QLabel* name_;
    QLabel* value_;
    ParameterEditor* editor_ = nullptr;
    StateLabel* verdict_;
    std::optional<Standing> failure_;
};

}  // namespace kickstand::ui
