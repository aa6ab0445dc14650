// Runs the instances of a folder and prints the report of the program
// team_orienteering.

#ifndef KG_SELECTOR_ORIENTEERING_TOP_REPORT_H_
#define KG_SELECTOR_ORIENTEERING_TOP_REPORT_H_

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "kg_selector/orienteering/team_orienteering.h"

namespace kg_selector {

struct TopScore {
  int instances = 0;  // Instances with a reference above 0.
  int hits = 0;       // Instances that reach the reference or exceed it.
  int above = 0;
  double value = 0.0;
  double reference = 0.0;
  double shares = 0.0;  // Sum of value / reference.
  double seconds = 0.0;
  int bounds = 0;        // Instances with a bound.
  double bounded = 0.0;  // Sum of values of instances with a bound.
  double bound = 0.0;    // Sum of their bounds.

  void Add(const TopScore& other);
  double share() const;  // Value over reference [%]; 100 without references.
};

// Instance files of a folder by name, without the reference file and hidden
// files. Throws kg_base::InputError if the folder is missing or empty.
std::vector<std::string> ListInstances(const std::string& folder,
                                       const std::string& reference_file);

// Runs every `step`th instance. Scores are keyed by set: the part of the file
// name before the first dot. Prints a line to `out` for each set and for each
// instance without a reference. Throws kg_base::InputError for a bad file,
// std::logic_error if a plan breaks a rule.
std::map<std::string, TopScore> RunTop(const std::string& folder,
                                       const std::string& reference_file,
                                       const TeamTourOptions& options,
                                       std::ostream* out, std::size_t step = 1);

}  // namespace kg_selector

#endif  // KG_SELECTOR_ORIENTEERING_TOP_REPORT_H_
