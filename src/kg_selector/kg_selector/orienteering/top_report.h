// Runs the instances of a folder and prints what the program team_orienteering
// prints.

#ifndef KG_SELECTOR_ORIENTEERING_TOP_REPORT_H_
#define KG_SELECTOR_ORIENTEERING_TOP_REPORT_H_

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "kg_selector/orienteering/team_orienteering.h"

namespace kg_selector {

struct TopScore {
  int instances = 0;  // With a reference above 0.
  int hits = 0;       // The reference reached, at least.
  int above = 0;
  double value = 0.0;
  double reference = 0.0;
  double shares = 0.0;  // Sum of value / reference.
  double seconds = 0.0;
  int bounds = 0;        // Instances with a bound.
  double bounded = 0.0;  // Their values,
  double bound = 0.0;    // and bounds.

  void Add(const TopScore& other);
  double share() const;  // Value over reference [%]; 100 without references.
};

// The files of a folder by name, the reference file and hidden ones left out.
// Throws kg_base::InputError if there is no such folder, or nothing in it.
std::vector<std::string> ListInstances(const std::string& folder,
                                       const std::string& reference_file);

// Every `step`th instance. Scores by set: what stands before the first dot of
// a file's name. A line on `out` for each set and for each instance without a
// reference. Throws kg_base::InputError for a bad file, std::logic_error if a
// plan breaks a rule.
std::map<std::string, TopScore> RunTop(const std::string& folder,
                                       const std::string& reference_file,
                                       const TeamTourOptions& options,
                                       std::ostream* out, std::size_t step = 1);

}  // namespace kg_selector

#endif  // KG_SELECTOR_ORIENTEERING_TOP_REPORT_H_
