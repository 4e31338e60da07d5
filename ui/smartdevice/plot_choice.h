#pragma once

#include <QTreeWidget>
#include <vector>

#include "core/smartdevice/snapshot.h"
#include "ui/plot/plot_contents.h"

class QSettings;

namespace kickstand::ui {

/// What a plot shows of some boards' parameters: those of one unit share an area.
struct PlotOfBoards {
    std::vector<PlotArea> areas;
    std::vector<PlotCurve> curves;
};

/// A tree of boards and their parameters with check boxes: what is plotted, with the colour and the letter of
/// its curve and its value now. What is checked is kept with the boards' UIDs.
class PlotChoice final : public QTreeWidget {
    Q_OBJECT
  public:
    explicit PlotChoice(QSettings& settings, QWidget* parent = nullptr);

    /// Takes what there is; null for nothing. True where something else is to be plotted than before.
    bool follow(const smartdevice::Snapshot* snapshot, TimePoint now);
    /// What is checked.
    const PlotOfBoards& contents() const { return contents_; }

  signals:
    /// Something else is to be plotted.
    void changed();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Row {
        int device = 0;
        int parameter = 0;
        QString key;
        QTreeWidgetItem* item = nullptr;
    };

    void rebuild(const smartdevice::Snapshot& snapshot);
    void addBoard(const smartdevice::DeviceState& device);
    void chooseFirst(const smartdevice::Snapshot& snapshot);
    void keep();
    void refreshContents(const smartdevice::Snapshot& snapshot);
    void refreshMarks();
    QString shapeOf(const smartdevice::Snapshot& snapshot) const;

    QSettings& settings_;
    QString shape_;
    std::vector<Row> rows_;
    PlotOfBoards contents_;
    bool dirty_ = true;
};

}  // namespace kickstand::ui
