// The two forms of a window's times, kept equal within a transaction (A26):
//
//   short, the paper's:   ex:w0 time:hasBeginning "2026-06-02T00:00:00Z"^^
//                             xsd:dateTime ; ex:durationHours 24 .
//   long, OWL-Time's:     ex:w0 time:hasTime <w0/time> .
//       <w0/time> a time:ProperInterval ; time:hasBeginning <w0/time/begin> ;
//           time:hasEnd <w0/time/end> .
//       <w0/time/begin> a time:Instant ; time:inXSDDateTimeStamp
//           "2026-06-02T00:00:00Z"^^xsd:dateTimeStamp .
//
// Either may be written, also a time:Instant in place of the short form's
// xsd:dateTime; both are stored. The short form stands on the window alone, so
// that nobody who asks for a window's begin gets two answers. The end is
// known to the long form if the window itself says it.
// https://www.w3.org/TR/owl-time/

#ifndef KG_MISSION_MISSION_TIME_FORMS_H_
#define KG_MISSION_MISSION_TIME_FORMS_H_

#include "kg_core/facts/changed_subjects.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Brings both forms up to date with what `transaction` changed in the facts.
void StageTimeForms(kg_core::Transaction& transaction,
                    kg_core::ChangeScope scope);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_TIME_FORMS_H_
