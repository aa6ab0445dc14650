// Reads a node's private parameters: every value is checked for type and range,
// and unknown keys are errors. A mistake in a launch file stops the node at
// startup.
//
//   ParameterReader read(ros::NodeHandle("~"));
//   options.deadline_s = read.Number("deadline_s", {0.1, 600.0}, 10.0);
//   read.RefuseTheRest();
//
// A key ends in its unit (_m, _s, _mps, _deg) where it has one.

#ifndef KG_ROS_BASE_PARAMETER_READER_H_
#define KG_ROS_BASE_PARAMETER_READER_H_

#include <string>

#include "ros/node_handle.h"
#include "xmlrpcpp/XmlRpcValue.h"

namespace kg_ros {

// A closed interval.
template <typename T>
struct Range {
  T min;
  T max;
};

// All functions throw kg_base::InputError, naming the node and the key.
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& own);
  ParameterReader(std::string name, const XmlRpc::XmlRpcValue& block);

  // Returns `fallback` if the key is missing.
  double Number(const std::string& key, Range<double> range, double fallback);
  int Integer(const std::string& key, Range<int> range, int fallback);
  bool Boolean(const std::string& key, bool fallback);
  std::string Text(const std::string& key, const std::string& fallback);
  // A required, non-empty text.
  std::string Text(const std::string& key);

  // Throws if a key has not been read: most likely a typo.
  void RefuseTheRest() const;

 private:
  // Returns the value of `key` and marks it as read; invalid if missing.
  XmlRpc::XmlRpcValue Take(const std::string& key);
  [[noreturn]] void Refuse(const std::string& key,
                           const std::string& complaint) const;

  std::string name_;
  XmlRpc::XmlRpcValue block_;
};

}  // namespace kg_ros

#endif  // KG_ROS_BASE_PARAMETER_READER_H_
