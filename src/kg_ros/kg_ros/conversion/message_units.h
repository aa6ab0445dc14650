// Units: degrees and Unix seconds of the libraries <-> radians and ros::Time of
// the messages; ids of agents <-> IRIs.

#ifndef KG_ROS_CONVERSION_MESSAGE_UNITS_H_
#define KG_ROS_CONVERSION_MESSAGE_UNITS_H_

#include <cmath>
#include <limits>

#include "kg_base/common/units.h"
#include "kg_base/geo/lon_lat.h"
#include "ros/time.h"

namespace kg_ros {

// Rounded to nanoseconds; missions have no times before 1970.
inline ros::Time ToRosTime(double unix_s) {
  return ros::Time(std::isfinite(unix_s) && unix_s > 0.0 ? unix_s : 0.0);
}
inline double FromRosTime(const ros::Time& time) { return time.toSec(); }

// Messages contain no infinities; NaN = unknown.
inline double FiniteOrUnknown(double value) {
  return std::isfinite(value) ? value
                              : std::numeric_limits<double>::quiet_NaN();
}

// For messages with lon_rad and lat_rad.
template <typename Message>
void SetPosition(const kg_base::LonLat& position, Message* message) {
  message->lon_rad = kg_base::DegToRad(position.lon_deg);
  message->lat_rad = kg_base::DegToRad(position.lat_deg);
}
template <typename Message>
kg_base::LonLat GetPosition(const Message& message) {
  return {kg_base::RadToDeg(message.lon_rad),
          kg_base::RadToDeg(message.lat_rad)};
}

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_MESSAGE_UNITS_H_
