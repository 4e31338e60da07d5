#pragma once

#include <QWidget>
#include <array>

#include "ui/thunderbots/choice_summary.h"

class QCheckBox;
class QPushButton;

namespace kickstand::ui {

class LimitRow;
class Segmented;
class SetPointSlider;

/// Four wheels, run or brake, the dribbler, and the limit. It shows and asks; the panel decides.
class WheelsBox final : public QWidget {
    Q_OBJECT
  public:
    explicit WheelsBox(QWidget* parent = nullptr);

    /// `wheels`: whether the set points may follow the snapshot, or a person's wish is still on its way.
    void showState(const ChoiceSummary& summary, int limit, bool wheels);
    void setUsable(bool usable);
    /// Everything to zero, whoever holds it.
    void reset();
    thunderbots::WheelSpeeds values() const;
    bool releasesToZero() const;
    void setReleaseToZero(bool on);

    SetPointSlider* wheel(int index) const { return wheels_[static_cast<std::size_t>(index)]; }

  signals:
    void wheelAsked(int wheel, int value, bool held);
    void runAsked();
    void brakeAsked();
    void zeroAsked();
    void dribblerAsked(bool on);
    void limitAsked(int limit);
    void releaseToZeroChanged(bool on);

  private:
    QWidget* makeTop();
    QWidget* makeBottom();

    Segmented* run_;
    QCheckBox* release_;
    std::array<SetPointSlider*, thunderbots::kWheels> wheels_{};
    QPushButton* dribbler_;
    QPushButton* zero_;
    LimitRow* limit_;
};

}  // namespace kickstand::ui
