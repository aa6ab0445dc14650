#include "kg_mission/mission/time_forms.h"

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kg_base/common/date_time.h"
#include "kg_base/common/units.h"
#include "kg_core/facts/changed_subjects.h"
#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"

namespace kg_mission {
namespace {

using kg_core::ChangedSubjects;
using kg_core::ChangeScope;
using kg_core::Ex;
using kg_core::Facts;
using kg_core::Linked;
using kg_core::RdfType;
using kg_core::Term;
using kg_core::TimeTerm;
using kg_core::Transaction;

Term HasTime() { return TimeTerm("hasTime"); }
Term Begin() { return TimeTerm("hasBeginning"); }
Term End() { return TimeTerm("hasEnd"); }
Term Stamp() { return TimeTerm("inXSDDateTimeStamp"); }

// True if FormatDateTime can represent the time: years 0 to 9999.
bool HasFormat(double unix_s) {
  return unix_s >= -62167219200.0 && unix_s < 253402300800.0;
}

class TimeForms {
 public:
  TimeForms(Transaction& transaction, ChangeScope scope)
      : transaction_(transaction), scope_(scope) {}

  void Keep() {
    const std::set<Term> by_short = ShortFormChanged();
    const std::set<Term> by_long = LongFormChanged();
    std::set<Term> all = by_long;
    all.insert(by_short.begin(), by_short.end());
    for (const Term& window : all) {
      TakeInstants(window);
      const bool is_short =
          by_short.count(window) != 0 && First(window, Begin());
      if (by_long.count(window) != 0 && !is_short) TakeInterval(window);
    }
    for (const Term& window : all) Renew(window);
    for (const Term& instant : taken_) DropUnused(instant);
  }

 private:
  const kg_core::GraphView& view() const { return transaction_.view(); }

  std::optional<Term> First(const Term& subject, const Term& property) const {
    return kg_core::FirstObject(view(), kg_core::kFactsGraph, subject,
                                property);
  }

  bool IsWindow(const Term& node) const {
    return kg_core::Has(view(), kg_core::kFactsGraph, node, RdfType(),
                        Ex("TimeWindow"));
  }

  // True if `node` has no class other than `type`, or no class at all.
  bool IsOnly(const Term& node, const Term& type) const {
    const std::vector<Term> types =
        kg_core::Objects(view(), kg_core::kFactsGraph, node, RdfType());
    return types.empty() || types == std::vector<Term>{type};
  }

  // Windows whose short form changed, including removed ones; without
  // intervals.
  std::set<Term> ShortFormChanged() const {
    std::set<Term> windows;
    for (const Term& property : {Begin(), End(), Ex("durationHours")}) {
      for (const Term& node : ChangedSubjects(transaction_, property, scope_)) {
        const bool is_gone = !First(node, RdfType());
        const bool had_interval =
            !Linked(transaction_, node, HasTime()).empty();
        if (IsWindow(node) || (is_gone && had_interval)) windows.insert(node);
      }
    }
    return windows;
  }

  std::set<Term> LongFormChanged() const {
    std::set<Term> intervals, windows;
    for (const Term& instant : ChangedSubjects(transaction_, Stamp(), scope_)) {
      for (const Term& property : {Begin(), End()}) {
        for (const Term& node : kg_core::Subjects(view(), kg_core::kFactsGraph,
                                                  property, instant)) {
          intervals.insert(node);
        }
      }
    }
    for (const Term& property : {Begin(), End()}) {
      intervals.merge(ChangedSubjects(transaction_, property, scope_));
    }
    // Propagate changes from instants to intervals, and from intervals to
    // windows.
    for (const Term& interval : intervals) {
      for (const Term& window : kg_core::Subjects(view(), kg_core::kFactsGraph,
                                                  HasTime(), interval)) {
        windows.insert(window);
      }
    }
    windows.merge(ChangedSubjects(transaction_, HasTime(), scope_));
    return windows;
  }

  // Time of a well-formed short form, Unix seconds.
  std::optional<double> Time_s(const Term& window, const Term& property) const {
    const std::optional<Term> value = First(window, property);
    return value ? kg_core::UnixSeconds(*value) : std::nullopt;
  }

  void SetShort(const Term& window, const Term& property, const Term& stamp) {
    transaction_.RemoveMatching(&window, &property, nullptr, Facts());
    transaction_.Add(
        {window, property,
         kg_core::Literal(stamp.text, std::string(kg_core::kXsd) + "dateTime"),
         Facts()});
  }

  // Replaces instants given in the short form by their xsd:dateTime.
  void TakeInstants(const Term& window) {
    for (const Term& property : {Begin(), End()}) {
      const std::optional<Term> instant = First(window, property);
      if (!instant || instant->is_literal()) continue;
      const std::optional<Term> stamp = First(*instant, Stamp());
      if (!stamp) continue;
      SetShort(window, property, *stamp);
      taken_.insert(*instant);
    }
  }

  void TakeInterval(const Term& window) {
    const std::optional<Term> interval = First(window, HasTime());
    if (!interval) return;
    for (const Term& property : {Begin(), End()}) {
      const std::optional<Term> instant = First(*interval, property);
      const std::optional<Term> stamp =
          instant ? First(*instant, Stamp()) : std::nullopt;
      if (stamp) SetShort(window, property, *stamp);
    }
  }

  // Rewrites the long form of a window. Nodes that are only an interval are
  // replaced; links to other nodes are left to the shapes to reject.
  void Renew(const Term& window) {
    if (!window.is_iri()) return;
    for (const Term& interval : Linked(transaction_, window, HasTime())) {
      if (!IsOnly(interval, TimeTerm("ProperInterval"))) continue;
      for (const Term& property : {Begin(), End()}) {
        taken_.merge(Linked(transaction_, interval, property));
      }
      transaction_.RemoveMatching(&interval, nullptr, nullptr, Facts());
      transaction_.Remove({window, HasTime(), interval, Facts()});
    }
    const std::optional<double> begin_s = Time_s(window, Begin());
    if (!IsWindow(window) || !begin_s || !HasFormat(*begin_s)) return;
    const Term interval = kg_core::Iri(window.text + "/time");
    transaction_.Add({window, HasTime(), interval, Facts()});
    transaction_.Add(
        {interval, RdfType(), TimeTerm("ProperInterval"), Facts()});
    AddInstant(interval, Begin(), *begin_s);
    AddInstant(interval, End(), End_s(window, *begin_s));
  }

  // NaN if the window does not state its end.
  double End_s(const Term& window, double begin_s) const {
    if (const auto end_s = Time_s(window, End())) return *end_s;
    const std::optional<Term> hours = First(window, Ex("durationHours"));
    return begin_s +
           kg_base::HoursToSeconds(
               hours ? kg_core::NumericValue(*hours).value_or(NAN) : NAN);
  }

  void AddInstant(const Term& interval, const Term& property, double unix_s) {
    if (!HasFormat(unix_s)) return;
    const Term instant =
        kg_core::Iri(interval.text + (property == Begin() ? "/begin" : "/end"));
    transaction_.RemoveMatching(&instant, nullptr, nullptr, Facts());
    transaction_.Add({interval, property, instant, Facts()});
    transaction_.Add({instant, RdfType(), TimeTerm("Instant"), Facts()});
    transaction_.Add(
        {instant, Stamp(),
         kg_core::Literal(kg_base::FormatDateTime(unix_s),
                          std::string(kg_core::kXsd) + "dateTimeStamp"),
         Facts()});
  }

  void DropUnused(const Term& instant) {
    if (instant.is_literal() || !IsOnly(instant, TimeTerm("Instant"))) return;
    kg_core::Quad pattern;
    pattern.object = view().Find(instant);
    pattern.graph = view().Find(Facts());
    bool is_used = pattern.object == kg_core::kNoTerm;
    if (!is_used) {
      view().Match(pattern, [&](const kg_core::Quad&) {
        is_used = true;
        return false;
      });
    }
    if (is_used) return;
    transaction_.RemoveMatching(&instant, nullptr, nullptr, Facts());
  }

  Transaction& transaction_;
  const ChangeScope scope_;
  std::set<Term> taken_;  // Instants that may no longer be needed.
};

}  // namespace

void StageTimeForms(Transaction& transaction, const ChangeScope scope) {
  TimeForms(transaction, scope).Keep();
}

}  // namespace kg_mission
