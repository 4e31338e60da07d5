#pragma once

#include <QProxyStyle>

class QAbstractButton;

namespace kickstand::ui {

/// How a button presents itself.
enum class ButtonRole { Normal, Primary, Danger, Flat };
void setButtonRole(QAbstractButton* button, ButtonRole role);

/// Where a button stands in a row of joined ones.
enum class ButtonEdge { Alone, First, Middle, Last };
void setButtonEdge(QAbstractButton* button, ButtonEdge edge);

/// Fusion with the bench's flat, quiet controls. All colours come from the palette (tokensOf), so that a
/// change of theme is a change of palette. A style and not a style sheet: it costs nothing at the start.
class BenchStyle final : public QProxyStyle {
    Q_OBJECT
  public:
    BenchStyle();

    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override;
    QRect subElementRect(SubElement element, const QStyleOption* option,
                         const QWidget* widget) const override;
    QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                         const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
};

}  // namespace kickstand::ui
