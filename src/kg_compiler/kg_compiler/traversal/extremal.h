// Extremals of Zermelo's problem: the tracks of earliest arrival.
//
// With x = (lon, lat) [deg], scale s(lat) = (s_lon, s_lat) [deg/m], current c
// [m/s], speed V through water and p the covector normal to the front [1/deg],
// Hamilton's equations are
//
//   dx_i/dt =  s_i (c_i + V h_i),            h = s p / |s p|  (heading)
//   dp_j/dt = -sum_i p_i s_i dc_i/dx_j  -  [j = lat] sum_i p_i ds_i/dlat
//             (c_i + V h_i)
//
// which is Zermelo's heading equation without angles. Positions are in cell
// units. p stays continuous across centre lines, where the spacing and the
// gradients of a bilinear field jump.
//
// E. Zermelo, ZAMM 11(2), 1931, pp. 114-124; A. E. Bryson and Y.-C. Ho,
// "Applied Optimal Control", 1975, section 2.7.

#ifndef KG_COMPILER_TRAVERSAL_EXTREMAL_H_
#define KG_COMPILER_TRAVERSAL_EXTREMAL_H_

#include <Eigen/Core>
#include <cmath>

#include "kg_compiler/traversal/flow.h"

namespace kg_compiler {

struct ExtremalState {
  double col = 0.0, row = 0.0;      // Position in cell units.
  double p_lon = 0.0, p_lat = 0.0;  // Normal of the front [1/deg].
};

// Initial state at a place; heading [rad] counter-clockwise from east.
ExtremalState SetOut(const FlowSampler& flow, kg_base::GridPoint from,
                     double heading_rad);

// Heading of an extremal [rad], counter-clockwise from east.
double HeadingOf(const FlowSampler& flow, const ExtremalState& at);

// Integrates extremals of one speed through one flow.
class ExtremalStepper {
 public:
  ExtremalStepper(const FlowSampler& flow, double speed_mps)
      : flow_(flow), speed_mps_(speed_mps) {}

  // Sampling times of one Runge-Kutta (RK4) step: begin, middle, end.
  struct Step {
    Step(const FlowSampler& flow, double begin_s, double length_s);
    double length_s;
    FlowSampler::Moment begin, middle, end;
  };
  ExtremalState Advance(const ExtremalState& from, const Step& step) const;

  // Velocity over ground [cells/s].
  kg_base::GridPoint Velocity(const ExtremalState& at,
                              const FlowSampler::Moment& moment) const;

 private:
  // Time derivative of (col, row, p_lon, p_lat) [1/s].
  Eigen::Vector4d Rate(const ExtremalState& at,
                       const FlowSampler::Moment& moment) const;

  const FlowSampler& flow_;
  double speed_mps_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_EXTREMAL_H_
