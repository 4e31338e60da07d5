#pragma once

#include <QWidget>

namespace kickstand::ui {

class Bench;

/// One panel of the window: what stands in a dock. A panel shows what the snapshot says and asks the engine
/// for what a person wants; it keeps no state of the robots of its own.
class Panel : public QWidget {
    Q_OBJECT
  public:
    explicit Panel(Bench& bench, QWidget* parent = nullptr);

    /// The words at the right end of the panel's header.
    QString note() const { return note_; }
    /// Controls that stand in the panel's header, where it has any. Asked for once.
    virtual QWidget* headerTools() { return nullptr; }
    /// A person has closed the panel: what is driven from it must not go on unseen.
    virtual void closed() {}
    /// Somebody asked for one thing in this panel (Bench::goTo()), by a name that the panel knows.
    virtual void showDetail(const QString& detail) { Q_UNUSED(detail) }
    /// The least that its lines take, wrapped at this width: a panel that scrolls in itself may be lower than
    /// it would like to be.
    int heightForWidth(int width) const override;

  signals:
    void noteChanged(const QString& note);

  protected:
    Bench& bench() const { return bench_; }
    void setNote(const QString& note);

  private:
    Bench& bench_;
    QString note_;
};

}  // namespace kickstand::ui
