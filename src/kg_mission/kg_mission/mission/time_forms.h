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
// Either form may be written, also a time:Instant in place of the short form's
// xsd:dateTime; both are stored. The short form is stored on the window only,
// so that a query for a window's begin has one answer. The long form has an end
// only if the window itself states it. https://www.w3.org/TR/owl-time/

#ifndef KG_MISSION_MISSION_TIME_FORMS_H_
#define KG_MISSION_MISSION_TIME_FORMS_H_

#include "kg_core/facts/changed_subjects.h"
#include "kg_core/rdf/store.h"

namespace kg_mission {

// Updates both forms for the changes of `transaction` to the facts.
void StageTimeForms(kg_core::Transaction& transaction,
                    kg_core::ChangeScope scope);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_TIME_FORMS_H_
