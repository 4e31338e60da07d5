#pragma once

#include <QFont>
#include <QRectF>
#include <QStringList>
#include <utility>
#include <vector>

#include "ui/thunderbots/tile_content.h"

namespace kickstand::ui {

/// Where everything of a tile stands. Nothing of it overlaps, whatever the robot is up to; what finds no room
/// as a word is drawn as a shape.
struct TileLayout {
    struct ChipBox {
        QRectF box;
        QStringList lines;  ///< None: its sign is drawn instead.
    };

    QRectF number;
    QRectF radio;  ///< The sign of how it is heard.
    QRectF motion;
    QRectF battery;
    QRectF batteryWord;
    QRectF batteryBar;
    QRectF lowestMark;
    QRectF capacitor;
    QRectF bolt;
    QRectF capacitorBar;
    QRectF state;
    QString stateText;  ///< As much of the state as there is room for.
    std::vector<ChipBox> chips;

    /// All that is drawn, by name.
    std::vector<std::pair<QString, QRectF>> parts() const;
};

/// The fonts of a tile.
QFont tileNumberFont();
QFont tileReadingFont(bool strong);
QFont tileWordFont(bool strong);

/// The least width that holds any content, from RobotTile::kLeastHeight up.
inline constexpr int kLeastTileWidth = 148;

TileLayout layOutTile(const TileContent& content, const QSizeF& size);

}  // namespace kickstand::ui
