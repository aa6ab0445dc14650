#include "kg_ros/base/parameter_reader.h"

#include <sstream>
#include <utility>

#include "kg_base/common/input_error.h"

namespace kg_ros {
namespace {

using XmlRpc::XmlRpcValue;

template <typename T>
std::string MustBe(const std::string& kind, const Range<T>& range) {
  std::ostringstream text;
  text << "must be " << kind << " in [" << range.min << ", " << range.max
       << "]";
  return text.str();
}

XmlRpcValue BlockOf(const ros::NodeHandle& own) {
  XmlRpcValue block;
  own.getParam(own.getNamespace(), block);
  if (block.getType() != XmlRpcValue::TypeStruct) return XmlRpcValue();
  return block;
}

}  // namespace

ParameterReader::ParameterReader(const ros::NodeHandle& own)
    : ParameterReader(own.getNamespace(), BlockOf(own)) {}

ParameterReader::ParameterReader(std::string name, const XmlRpcValue& block)
    : name_(std::move(name)), block_(block) {}

double ParameterReader::Number(const std::string& key,
                               const Range<double> range,
                               const double fallback) {
  XmlRpcValue value = Take(key);
  if (!value.valid()) return fallback;
  const bool whole = value.getType() == XmlRpcValue::TypeInt;
  if (!whole && value.getType() != XmlRpcValue::TypeDouble) {
    Refuse(key, MustBe("a number", range));
  }
  const double number =
      whole ? static_cast<int>(value) : static_cast<double>(value);
  if (!(range.min <= number && number <= range.max)) {
    Refuse(key, MustBe("a number", range));
  }
  return number;
}

int ParameterReader::Integer(const std::string& key, const Range<int> range,
                             const int fallback) {
  XmlRpcValue value = Take(key);
  if (!value.valid()) return fallback;
  if (value.getType() != XmlRpcValue::TypeInt) {
    Refuse(key, MustBe("an integer", range));
  }
  const int integer = static_cast<int>(value);
  if (integer < range.min || range.max < integer) {
    Refuse(key, MustBe("an integer", range));
  }
  return integer;
}

bool ParameterReader::Boolean(const std::string& key, const bool fallback) {
  XmlRpcValue value = Take(key);
  if (!value.valid()) return fallback;
  if (value.getType() != XmlRpcValue::TypeBoolean) {
    Refuse(key, "must be true or false");
  }
  return static_cast<bool>(value);
}

std::string ParameterReader::Text(const std::string& key,
                                  const std::string& fallback) {
  XmlRpcValue value = Take(key);
  if (!value.valid()) return fallback;
  if (value.getType() != XmlRpcValue::TypeString) {
    Refuse(key, "must be a text");
  }
  return static_cast<std::string>(value);
}

std::string ParameterReader::Text(const std::string& key) {
  std::string text = Text(key, "");
  if (text.empty()) Refuse(key, "is missing: must be a text");
  return text;
}

void ParameterReader::RefuseTheRest() const {
  if (block_.getType() != XmlRpcValue::TypeStruct) return;
  XmlRpcValue rest = block_;  // XmlRpcValue has no const iterators.
  for (auto& [key, value] : rest) {
    if (value.valid()) Refuse(key, "is not a known parameter");
  }
}

XmlRpcValue ParameterReader::Take(const std::string& key) {
  if (block_.getType() != XmlRpcValue::TypeStruct || !block_.hasMember(key)) {
    return XmlRpcValue();
  }
  XmlRpcValue value = block_[key];
  block_[key] = XmlRpcValue();  // Mark as read.
  return value;
}

void ParameterReader::Refuse(const std::string& key,
                             const std::string& complaint) const {
  throw kg_base::InputError("parameter " + name_ + "/" + key + " " + complaint);
}

}  // namespace kg_ros
