// How an agent moves.

#ifndef KG_COMPILER_TRAVERSAL_MOTION_H_
#define KG_COMPILER_TRAVERSAL_MOTION_H_

namespace kg_compiler {

// Speeds through water and energy consumption.
struct MotionModel {
  double cruise_mps = 0.0;  // Through water, along a seam.
  double max_mps = 0.0;     // For holding station only.
  double boost_gain = 1.0;  // Fraction of the current that acts on it (A17).
  // Propulsion energy per metre through water (A46).
  double energy_per_m_j = 0.0;
  double hotel_load_w = 0.0;
  // Lower bound of the speed charged for holding station [m/s]: 0, or the
  // cruise speed for an agent that must hover.
  double rest_mps = 0.0;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_MOTION_H_
