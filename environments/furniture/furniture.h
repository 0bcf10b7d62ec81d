/// The furniture of the scenes that the project makes itself; sizes are those of common furniture.
///
/// World axes, z up, metres: each piece stands on z = 0 around the origin and its front faces -y.
#pragma once

#include <vector>

#include "environments/furniture/mesh_kit.h"

namespace amble {

Furniture makePiano();        ///< a baby grand with its lid raised: 1.5 x 1.58 m, keys at -y
Furniture makePianoStool();   ///< a padded seat at 0.50 m on four legs: 0.44 x 0.34 m
Furniture makeSofa();         ///< for three: 2.15 x 0.92 m, seat at 0.44 m
Furniture makeArmchair();     ///< 0.86 x 0.86 m, seat at 0.43 m
Furniture makeLowTable();     ///< 0.60 x 0.90 m, 0.42 m high, with a shelf and a bowl
Furniture makeDiningTable();  ///< 1.50 x 0.85 m, 0.74 m high
Furniture makeChair();        ///< 0.44 x 0.48 m, seat at 0.45 m, slatted back to 0.92 m
Furniture makeLamp();         ///< a floor lamp 1.62 m high, shade of 0.42 m
Furniture makeBookshelf();    ///< 1.20 x 0.30 m, 2.0 m high, filled
Furniture makePlant();        ///< in a pot, about 1.3 m high
Furniture
makeDoor();  ///< a closed door leaf 0.80 x 2.00 m in its frame, handle to -y; its back is at y = 0
Furniture makePicture();  ///< framed, 0.9 x 0.6 m around the origin; its back is at y = 0

/// All of them, in this order; each becomes meshes/<name>.obj.
std::vector<Furniture> makeLivingRoomFurniture();

/// A closed cupboard 1.10 x 0.84 m, 2.10 m high: one closed shell around a solid inside, with doors
/// and handles.
Furniture makeCupboard();

/// Rolling ground of 16 x 10 m about the origin, on a block that reaches down to z = -1: two waves
/// across one another, slopes of up to 15 degrees, heights within 0.47 m of 0.
Furniture makeTerrain();

}  // namespace amble
