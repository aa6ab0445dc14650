// How an agent moves.

#ifndef KG_COMPILER_TRAVERSAL_MOTION_H_
#define KG_COMPILER_TRAVERSAL_MOTION_H_

namespace kg_compiler {

// Motion through water and its price.
struct MotionModel {
  double cruise_mps = 0.0;      // Through water, along a seam.
  double max_mps = 0.0;         // For holding station only.
  double boost_gain = 1.0;      // Share of the current that carries (A17).
  double energy_per_m_j = 0.0;  // Through water (A46).
  double hotel_load_w = 0.0;
  // Least speed that holding station is paid for: 0, or the cruise speed of
  // what hovers.
  double rest_mps = 0.0;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_MOTION_H_
