#pragma once

#include <QTimer>
#include <optional>

#include "ui/plot/plot_contents.h"
#include "ui/shell/panel.h"

class QLabel;

namespace kickstand::ui {

class DeviceChoice;
class PlotChoice;
class TimePlot;

/// Live curves of any parameters of any boards together, chosen in a tree beside them.
class PlotsPanel final : public Panel {
    Q_OBJECT
  public:
    PlotsPanel(Bench& bench, DeviceChoice& choice, QWidget* parent = nullptr);

    QWidget* headerTools() override;
    TimePlot& plot() { return *plot_; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void build();
    void refresh();
    QWidget* makeSave(QWidget* parent);
    std::optional<MarkWords> wordsOf(const Mark& mark) const;

    PlotChoice* tree_;
    TimePlot* plot_;
    QLabel* empty_;
    QTimer numbers_;
};

}  // namespace kickstand::ui
