#pragma once

#include <QWidget>

class QPainter;

namespace kickstand::ui {

struct Tokens;

/// How a state stands with the person who reads it. Each has a shape of its own beside its colour.
enum class Tone {
    Idle,     ///< A ring: nothing there, nothing wrong.
    Busy,     ///< A half disc: on its way.
    Good,     ///< A disc.
    Warning,  ///< A triangle.
    Danger,   ///< A square.
};

QColor toneColour(Tone tone, const Tokens& tokens);
/// The tone's shape, filling `box`.
void drawTone(QPainter& painter, Tone tone, const QRectF& box, const QColor& colour);

/// A small shape and the words of a state: "● Simulated dongle · radios running".
class StateLabel final : public QWidget {
    Q_OBJECT
  public:
    explicit StateLabel(QWidget* parent = nullptr);

    /// `strong` is written in bold after `text`.
    void setState(Tone tone, const QString& text, const QString& strong = {});
    Tone tone() const { return tone_; }
    /// All the words, as they are read.
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Tone tone_ = Tone::Idle;
    QString text_;
    QString strong_;
};

}  // namespace kickstand::ui
