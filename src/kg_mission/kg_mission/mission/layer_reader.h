// Reads the raster references in the facts: value layers, work fields, priors,
// masks, and their source files.

#ifndef KG_MISSION_MISSION_LAYER_READER_H_
#define KG_MISSION_MISSION_LAYER_READER_H_

#include <optional>
#include <string>

#include "kg_mission/mission/calendar.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/mission.h"

namespace kg_mission {

// ex:gridRef of a constraint that denotes the land of the work field.
inline constexpr char kLandRef[] = "land";

// The parts of "file#variable@step"; "@step" is optional, default 0.
struct GridRef {
  std::string file;
  std::string variable;
  int time_index = 0;
};

// All throw InputError.

// ex:gridRef of a prior layer or a constraint; nullopt if absent or "land".
std::optional<GridRef> ReadGridRef(const FactEntity& entity);
// The same with the ingested file (ingest.h): an ex:SourceFile named after the
// layer, with suffix "/file".
std::optional<RasterRef> ReadRasterRef(const FactEntity& entity);
kg_base::Resampling ReadResampling(
    const FactEntity& entity);  // kNone if absent.
std::string FileIri(const std::string& ingested_from);

ValueLayer ReadValueLayer(const WindowCalendar& calendar,
                          const FactEntity& entity);
WorkFieldRef ReadWorkField(const WindowCalendar& calendar,
                           const FactEntity& entity);
CostFieldRef ReadCostField(const WindowCalendar& calendar,
                           const FactEntity& entity);
kg_core::SourceFile ReadSourceFile(const FactEntity& entity);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_LAYER_READER_H_
