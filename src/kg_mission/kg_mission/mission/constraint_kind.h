// Table of constraint kinds, one row each: name in facts (ex:kind), cells
// covered by an area, effect on the value there, and colour. Used by the
// reader, the tensor compiler, explanations and displays. A new kind needs an
// enumerator, a row, and its name in the ontology's shape.

#ifndef KG_MISSION_MISSION_CONSTRAINT_KIND_H_
#define KG_MISSION_MISSION_CONSTRAINT_KIND_H_

#include <stdexcept>

#include "kg_base/raster/wkt_raster.h"

namespace kg_mission {

enum class ConstraintKind { kNoGo, kSoft };

// Red, green and blue components in [0, 1].
struct RgbColour {
  double red;
  double green;
  double blue;
};

struct ConstraintEffect {
  const char* name;  // Name in ex:kind.
  ConstraintKind value;
  // True: the value inside is 0 and no agent may enter (M_hard). False: the
  // value inside is multiplied by ex:attenuation (M_soft).
  bool forbids;
  kg_base::CellCover cover;  // Cells covered by an area, without buffer.
  // The kind (with forbids = true) whose effect applies to an agent that must
  // avoid it (ex:mustAvoid).
  ConstraintKind when_avoided;
  RgbColour colour;  // Outline colour in displays.
};

// Supercover is conservative for forbidden areas (A15); cell centres keep the
// extent of a factor unbiased (A10).
inline constexpr ConstraintEffect kConstraintEffects[] = {
    {"no_go",
     ConstraintKind::kNoGo,
     true,
     kg_base::CellCover::kTouched,
     ConstraintKind::kNoGo,
     {0.9, 0.1, 0.1}},
    {"soft",
     ConstraintKind::kSoft,
     false,
     kg_base::CellCover::kCentres,
     ConstraintKind::kNoGo,
     {1.0, 0.6, 0.0}},
};

// The row of a kind. Throws std::logic_error if there is none.
inline const ConstraintEffect& EffectOf(ConstraintKind kind) {
  for (const ConstraintEffect& effect : kConstraintEffects) {
    if (effect.value == kind) return effect;
  }
  throw std::logic_error("a kind of constraint without an effect");
}

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_CONSTRAINT_KIND_H_
