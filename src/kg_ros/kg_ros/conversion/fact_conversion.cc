#include "kg_ros/conversion/fact_conversion.h"

#include <vector>

namespace kg_ros {
namespace {

std::vector<kg_core::Fact> FromMessage(
    const std::vector<kg_msgs::Fact>& message) {
  std::vector<kg_core::Fact> facts;
  facts.reserve(message.size());
  for (const kg_msgs::Fact& fact : message) {
    facts.push_back({fact.subject, fact.property, fact.value});
  }
  return facts;
}

}  // namespace

kg_core::FactUpdate FromMessage(const kg_msgs::FactUpdate& message) {
  kg_core::FactUpdate update;
  update.id = message.id;
  update.author = message.author.empty() ? "unknown" : message.author;
  update.set = FromMessage(message.set);
  update.add = FromMessage(message.add);
  update.remove = FromMessage(message.remove);
  update.turtle = message.turtle;
  update.sparql = message.sparql;
  return update;
}

}  // namespace kg_ros
