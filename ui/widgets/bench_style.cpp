#include "ui/widgets/bench_style.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QStyleOption>

#include "ui/widgets/menu_drawing.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/tab_drawing.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr const char* kRoleProperty = "benchRole";
constexpr const char* kEdgeProperty = "benchEdge";
constexpr int kCheckBoxSize = 16;
constexpr int kFieldPadding = 4;
constexpr int kComboLeft = 6;
constexpr int kComboRight = 24;
constexpr int kComboSlack = 8;
constexpr int kScrollBarExtent = 10;
constexpr int kShortestScrollThumb = 24;

ButtonRole roleOf(const QWidget* widget) {
    return widget == nullptr ? ButtonRole::Normal
                             : static_cast<ButtonRole>(widget->property(kRoleProperty).toInt());
}

ButtonEdge edgeOf(const QWidget* widget) {
    return widget == nullptr ? ButtonEdge::Alone
                             : static_cast<ButtonEdge>(widget->property(kEdgeProperty).toInt());
}

bool has(const QStyleOption& option, QStyle::StateFlag flag) {
    return option.state.testFlag(flag);
}

struct ButtonColours {
    QColor fill;
    QColor border;
    QColor text;
};

ButtonColours buttonColours(const QStyleOption& option, ButtonRole role) {
    const Tokens& t = tokensOf(option.palette);
    const bool enabled = has(option, QStyle::State_Enabled);
    const bool over = enabled && has(option, QStyle::State_MouseOver);
    const bool down = enabled && has(option, QStyle::State_Sunken);
    const QColor plainText = option.palette.color(QPalette::ButtonText);
    if (has(option, QStyle::State_On)) {
        if (!enabled) return {t.grid, t.line, plainText};
        return {down ? t.surface : t.accentSoft, t.accent, t.accent};
    }
    if (enabled && role == ButtonRole::Primary) {
        const QColor fill = down ? t.accent.darker(120) : over ? t.accent.darker(108) : t.accent;
        return {fill, fill, t.onAccent};
    }
    if (enabled && role == ButtonRole::Danger) {
        return {down || over ? t.dangerSoft : t.surface, t.danger, t.danger};
    }
    if (role == ButtonRole::Flat) {
        const QColor fill = down || over ? t.grid : QColor(Qt::transparent);
        return {fill, Qt::transparent, plainText};
    }
    return {down ? t.grid : t.surface, over ? t.muted : t.line, plainText};
}

/// A rounded rectangle whose joined sides are square.
QPainterPath buttonShape(const QRectF& rect, ButtonEdge edge) {
    QPainterPath path;
    const double r = metrics::kControlRadius;
    path.addRoundedRect(rect, r, r);
    if (edge == ButtonEdge::Alone) return path;
    QPainterPath square;
    if (edge != ButtonEdge::First) square.addRect(rect.adjusted(0, 0, -rect.width() / 2, 0));
    if (edge != ButtonEdge::Last) square.addRect(rect.adjusted(rect.width() / 2, 0, 0, 0));
    return path.united(square);
}

void drawButton(const QStyleOption& option, QPainter& painter, const QWidget* widget) {
    const ButtonColours colours = buttonColours(option, roleOf(widget));
    const Tokens& t = tokensOf(option.palette);
    const bool focus = has(option, QStyle::State_HasFocus) && has(option, QStyle::State_KeyboardFocusChange);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(focus ? QPen(t.accent, 2) : QPen(colours.border, 1));
    painter.setBrush(colours.fill);
    const double inset = focus ? 1 : 0.5;
    painter.drawPath(buttonShape(QRectF(option.rect).adjusted(inset, inset, -inset, -inset), edgeOf(widget)));
    painter.restore();
}

void drawField(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokensOf(option.palette);
    const bool enabled = has(option, QStyle::State_Enabled);
    const bool focus = enabled && has(option, QStyle::State_HasFocus);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(focus ? QPen(t.accent, 1.5) : QPen(t.line, 1));
    painter.setBrush(enabled ? t.surface : t.background);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.75, 0.75, -0.75, -0.75), 5, 5);
    painter.restore();
}

/// The two arrows of a spin box, each where it is clicked.
void drawSteps(const QStyle& style, const QStyleOptionSpinBox& option, QPainter& painter,
               const QWidget* widget) {
    if (option.buttonSymbols == QAbstractSpinBox::NoButtons) return;
    const Tokens& t = tokensOf(option.palette);
    const auto draw = [&](QStyle::SubControl part, QAbstractSpinBox::StepEnabledFlag step, int turn) {
        const QRectF place = style.subControlRect(QStyle::CC_SpinBox, &option, part, widget);
        const bool usable = has(option, QStyle::State_Enabled) && option.stepEnabled.testFlag(step);
        const bool over = usable && option.activeSubControls == part && has(option, QStyle::State_MouseOver);
        if (over) painter.fillRect(place.adjusted(0, 1, -1, -1), t.grid);
        painter.save();
        painter.translate(place.center());
        painter.rotate(turn);
        drawChevron(painter, {}, usable ? option.palette.color(QPalette::ButtonText) : t.line);
        painter.restore();
    };
    draw(QStyle::SC_SpinBoxUp, QAbstractSpinBox::StepUpEnabled, 180);
    draw(QStyle::SC_SpinBoxDown, QAbstractSpinBox::StepDownEnabled, 0);
}

void drawCheckBox(const QStyleOption& option, QPainter& painter) {
    const Tokens& t = tokensOf(option.palette);
    const bool enabled = has(option, QStyle::State_Enabled);
    const bool on = has(option, QStyle::State_On);
    const QColor mark = enabled ? t.accent : t.muted;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
    painter.setPen(QPen(on ? mark : has(option, QStyle::State_MouseOver) ? t.accent : t.muted, 1));
    painter.setBrush(on ? mark : t.surface);
    painter.drawRoundedRect(box, 3, 3);
    if (on) {
        painter.setPen(QPen(t.onAccent, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF c = box.center();
        painter.drawPolyline(
            QPolygonF{c + QPointF(-3.2, 0.2), c + QPointF(-0.8, 2.6), c + QPointF(3.4, -2.6)});
    }
    painter.restore();
}

void drawScrollBar(const QStyleOptionSlider& option, QPainter& painter, const QRect& thumb) {
    const Tokens& t = tokensOf(option.palette);
    if (option.minimum == option.maximum) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const bool used = option.activeSubControls.testFlag(QStyle::SC_ScrollBarSlider);
    painter.setBrush(used ? t.muted : t.line);
    painter.drawRoundedRect(QRectF(thumb).adjusted(2, 2, -2, -2), 3, 3);
    painter.restore();
}

}  // namespace

void setButtonRole(QAbstractButton* button, ButtonRole role) {
    button->setProperty(kRoleProperty, static_cast<int>(role));
}

void setButtonEdge(QAbstractButton* button, ButtonEdge edge) {
    button->setProperty(kEdgeProperty, static_cast<int>(edge));
}

BenchStyle::BenchStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void BenchStyle::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    if (qobject_cast<QAbstractButton*>(widget) != nullptr) widget->setAttribute(Qt::WA_Hover);
}

int BenchStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    switch (metric) {
        case PM_DockWidgetSeparatorExtent:
            return metrics::kGap;
        case PM_DockWidgetFrameWidth:
        case PM_ButtonShiftHorizontal:
        case PM_ButtonShiftVertical:
            return 0;
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
            return kCheckBoxSize;
        case PM_ScrollBarExtent:
            return kScrollBarExtent;
        case PM_MenuHMargin:
        case PM_MenuVMargin:
            return 4;
        case PM_MenuButtonIndicator:
            return 12;
        default:
            return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int BenchStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* data) const {
    if (hint == SH_UnderlineShortcut) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
}

QSize BenchStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                   const QWidget* widget) const {
    switch (type) {
        case CT_PushButton: {
            const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
            const bool menu = button != nullptr && button->features.testFlag(QStyleOptionButton::HasMenu);
            return {contents.width() + 2 * metrics::kPadding + 2 + (menu ? 4 : 0), metrics::kControlHeight};
        }
        case CT_ComboBox:
            return {contents.width() + kComboLeft + kComboRight + kComboSlack, metrics::kFieldHeight};
        case CT_LineEdit:
        case CT_SpinBox:
            return {QProxyStyle::sizeFromContents(type, option, contents, widget).width(),
                    metrics::kFieldHeight};
        case CT_TabBarTab:
            if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) return tabSize(*tab);
            return QProxyStyle::sizeFromContents(type, option, contents, widget);
        case CT_MenuItem:
            if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option))
                return menuItemSize(*item);
            return contents;
        default:
            return QProxyStyle::sizeFromContents(type, option, contents, widget);
    }
}

QRect BenchStyle::subElementRect(SubElement element, const QStyleOption* option,
                                 const QWidget* widget) const {
    // The words of a tab have all of it: its size has their margins.
    if (element == SE_TabBarTabText) return option->rect;
    const QRect rect = QProxyStyle::subElementRect(element, option, widget);
    const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
    const bool alone = element == SE_LineEditContents && frame != nullptr && frame->lineWidth > 0;
    return alone ? rect.adjusted(kFieldPadding, 0, -kFieldPadding, 0) : rect;
}

QRect BenchStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                 const QWidget* widget) const {
    if (control == CC_ComboBox && part == SC_ComboBoxEditField) {
        return option->rect.adjusted(kComboLeft, 1, -kComboRight, -1);
    }
    const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (control != CC_ScrollBar || bar == nullptr)
        return QProxyStyle::subControlRect(control, option, part, widget);
    const bool horizontal = bar->orientation == Qt::Horizontal;
    const int length = horizontal ? bar->rect.width() : bar->rect.height();
    const qint64 range = qint64(bar->maximum) - bar->minimum;
    int thumb = length;
    if (range > 0) thumb = static_cast<int>(qint64(bar->pageStep) * length / (range + bar->pageStep));
    thumb = qBound(qMin(kShortestScrollThumb, length), thumb, length);
    const int start = sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition, length - thumb,
                                              bar->upsideDown);
    const auto piece = [&](int from, int size) {
        return horizontal ? QRect(from, 0, size, bar->rect.height())
                          : QRect(0, from, bar->rect.width(), size);
    };
    switch (part) {
        case SC_ScrollBarGroove:
            return bar->rect;
        case SC_ScrollBarSlider:
            return piece(start, thumb);
        case SC_ScrollBarSubPage:
            return piece(0, start);
        case SC_ScrollBarAddPage:
            return piece(start + thumb, length - start - thumb);
        default:
            return {};
    }
}

void BenchStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const {
    switch (element) {
        case PE_PanelButtonCommand:
            drawButton(*option, *painter, widget);
            return;
        case PE_PanelLineEdit:
            // Inside a spin box or a combo box the frame is theirs.
            if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
                frame->lineWidth > 0) {
                drawField(*option, *painter);
            }
            return;
        case PE_IndicatorCheckBox:
            drawCheckBox(*option, *painter);
            return;
        case PE_IndicatorArrowDown: {
            const QColor colour = option->palette.color(QPalette::ButtonText);
            drawChevron(*painter, QRectF(option->rect).center(), colour);
            return;
        }
        case PE_IndicatorDockWidgetResizeHandle:
        case PE_FrameTabBarBase:
            return;
        case PE_FrameFocusRect:
            // Buttons show their focus in their border.
            if (qobject_cast<const QPushButton*>(widget) != nullptr) return;
            painter->save();
            painter->setRenderHint(QPainter::Antialiasing);
            painter->setPen(QPen(tokensOf(option->palette).accent, 1.5));
            painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 1, -1, -1), 4, 4);
            painter->restore();
            return;
        case PE_PanelMenu:
        case PE_FrameMenu:
            drawMenuPanel(*option, *painter);
            return;
        default:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void BenchStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
    if (element == CE_PushButtonLabel) {
        if (const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option)) {
            QStyleOptionButton coloured(*button);
            coloured.palette.setColor(QPalette::ButtonText, buttonColours(*option, roleOf(widget)).text);
            QProxyStyle::drawControl(element, &coloured, painter, widget);
            return;
        }
    }
    if (element == CE_TabBarTab) {
        if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) drawTab(*tab, *painter);
        return;
    }
    const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
    if (element == CE_MenuItem && item != nullptr) {
        drawMenuItem(*item, *painter);
        return;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void BenchStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                    QPainter* painter, const QWidget* widget) const {
    switch (control) {
        case CC_SpinBox:
            drawField(*option, *painter);
            if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option))
                drawSteps(*this, *spin, *painter, widget);
            return;
        case CC_ComboBox:
            drawField(*option, *painter);
            drawChevron(*painter, QRectF(option->rect).center() + QPointF(option->rect.width() / 2.0 - 14, 0),
                        option->palette.color(QPalette::ButtonText));
            return;
        case CC_ScrollBar:
            drawScrollBar(*qstyleoption_cast<const QStyleOptionSlider*>(option), *painter,
                          subControlRect(control, option, SC_ScrollBarSlider, widget));
            return;
        default:
            QProxyStyle::drawComplexControl(control, option, painter, widget);
    }
}

}  // namespace kickstand::ui
