#pragma once

#include <QWidget>
#include <array>

#include "core/thunderbots/parameter_draft.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace kickstand::ui {

class ParametersField;

/// The fields of a robot's parameters in rows: what the robot has, the draft, and a file or an earlier
/// reading; what differs is marked, and what is to be applied ticked.
class ParametersGrid final : public QWidget {
    Q_OBJECT
  public:
    explicit ParametersGrid(QWidget* parent = nullptr);

    /// Shows these; `other` is what stands in the third column, under its title.
    void showValues(const thunderbots::ParameterDraft& draft, const thunderbots::ParameterValues& other,
                    const QString& otherTitle, bool editable);
    /// The changed fields whose tick is set. New changes are ticked.
    thunderbots::ParameterMask ticked() const;

  signals:
    void edited(thunderbots::ParameterField field, std::uint8_t value, bool goesOn);
    /// One field is to be taken over from the third column.
    void takeAsked(thunderbots::ParameterField field);
    /// All of them are, but for the flash contents.
    void takeAllAsked();
    void ticksChanged();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void colourMarks();
    struct Row {
        QCheckBox* tick = nullptr;
        QLabel* name = nullptr;
        QLabel* robot = nullptr;
        QLabel* mark = nullptr;
        ParametersField* draft = nullptr;
        QLabel* other = nullptr;
        QToolButton* take = nullptr;
    };
    void addHeader(QGridLayout* grid);
    void addRow(QGridLayout* grid, thunderbots::ParameterField field);
    void showRow(thunderbots::ParameterField field, const thunderbots::ParameterDraft& draft,
                 const thunderbots::ParameterValues& other, bool editable);
    Row& row(thunderbots::ParameterField field) { return rows_[static_cast<std::size_t>(field)]; }

    std::array<Row, thunderbots::kParameterFieldCount> rows_;
    QLabel* otherTitle_ = nullptr;
    QToolButton* takeAll_ = nullptr;
    thunderbots::ParameterMask changes_ = 0;
};

}  // namespace kickstand::ui
