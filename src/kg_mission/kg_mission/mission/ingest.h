// The adapter from files to facts (paper, "Data Ingestion"): for every
// ex:DataSource of the mission it reads the file, and states for each window
// the ex:CurrentField and ex:ValueLayer that come from it, with the file's
// path, sha256, variable and time indices as provenance. Files that prior
// layers and constraints name by ex:gridRef are read and stated likewise.
//
// Facts it reads (facts graph):
//   ex:currents a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "current" .
//       (or "wind": then ex:WorkField for ex:CurrentField below)
//   ex:sst      a ex:DataSource ; ex:file "ocean.nc" ; ex:provides
//   "temperature" ; ex:kind, ex:resampling, ex:fullScale, ex:frontFullScale .
//   ex:reefs a ex:PriorLayer ; ex:gridRef "habitat.nc#reef@0" ;
//       ex:resampling .
//   ex:hotspots a ex:SampledField ; ex:gridRef "map.nc#score" ;
//       ex:sampleAbove 0.8 .
// Facts it states, replacing those of an earlier ingest of the same source:
//   ex:currents\/file   a ex:SourceFile ; ex:path, ex:sha256 .
//   ex:currents\/w3     a ex:CurrentField ; ex:forWindow ; ex:gridRefU,
//       ex:gridRefV "path#variable@first..last" ; ex:firstTimeIndex,
//       ex:lastTimeIndex ; sosa:observedProperty ; prov:wasDerivedFrom .
//   ex:sst\/w3          a ex:ValueLayer ; ex:forWindow ; ex:kind "delta_sst" ;
//       ex:gridRef ; ex:timeIndex, ex:previousTimeIndex ; prov:wasDerivedFrom ;
//       resampling and scales of its source .
//   ex:currents\/quality\/0  a ex:DataQualityReport (data_quality.h), of each
//       variable that was read.
//   ex:reefs\/file      a ex:SourceFile ; ex:path, ex:sha256 .
//   ex:hotspots\/cell/4_2  a ex:CellSample ; geo:asWKT ; ex:cellValue .
//   ex:grid a ex:GridSpec ; ex:rows, ex:cols, geo:asWKT, ex:pixelSizeKm .
//   ex:sst\/grid, ex:reefs\/grid: likewise, where it is not ex:grid.
//
// ex:grid is the grid of the currents and the mission's. A file on another grid
// is rejected unless ex:resampling declares how to resample it (A54).
//
// |delta SST| of window t is the difference between the temperature step
// nearest to its middle and the one a day earlier; the first window uses the
// day before it, else the forward difference, else the file is rejected as too
// short (A14).

#ifndef KG_MISSION_MISSION_INGEST_H_
#define KG_MISSION_MISSION_INGEST_H_

#include <string>
#include <vector>

#include "kg_core/rdf/store.h"
#include "kg_mission/mission/file_cache.h"
#include "kg_mission/mission/ingested_facts.h"
#include "kg_mission/mission/stage_update.h"

namespace kg_mission {

// Stages the facts of every data source in `transaction`, and the conclusions
// of the rules. Returns the reasons if that fails (too few days for the
// windows, all land, facts that violate a shape, ...); empty = success.
std::vector<std::string> StageIngest(FileCache& cache,
                                     kg_core::Transaction& transaction);

// The files named by facts that are not there, as one line each; files that are
// there may still be unreadable.
std::vector<std::string> FindMissingFiles(const FileCache& cache,
                                          const kg_core::GraphView& view);

// StageUpdate (stage_update.h), followed by StageIngest if due: all checks of
// an update except that the mission can be read.
struct StagedUpdate {
  UpdateJudgement judgement;
  double ingest_s = 0.0;  // Wall-clock time to read files.
};
StagedUpdate StageUpdateWithFiles(const kg_core::FactUpdate& update,
                                  FileCache& cache,
                                  kg_core::Transaction& transaction);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_INGEST_H_
