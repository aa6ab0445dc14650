// The adapter from files to facts (paper, "Data Ingestion"): for every
// ex:DataSource of the mission it reads the file, and states for each window
// the ex:CurrentField and ex:ValueLayer that come from it, with the file's
// path, sha256, variable and time indices as provenance.
//
// Facts it reads (facts graph):
//   ex:currents a ex:DataSource ; ex:file "ocean.nc" ; ex:provides "current" .
//   ex:sst      a ex:DataSource ; ex:file "ocean.nc" ; ex:provides
//   "temperature" .
// Facts it states, replacing those of an earlier ingest of the same source:
//   ex:currents\/file   a ex:SourceFile ; ex:path, ex:sha256 .
//   ex:currents\/w3     a ex:CurrentField ; ex:forWindow ; ex:gridRefU,
//       ex:gridRefV "path#variable@first..last" ; ex:firstTimeIndex,
//       ex:lastTimeIndex ; sosa:observedProperty ; prov:wasDerivedFrom .
//   ex:sst\/w3          a ex:ValueLayer ; ex:forWindow ; ex:kind "delta_sst" ;
//       ex:gridRef ; ex:timeIndex, ex:previousTimeIndex ; prov:wasDerivedFrom .
//   ex:grid a ex:GridSpec ; ex:rows, ex:cols, geo:asWKT, ex:pixelSizeKm .
//
// |delta SST| of window t is between the temperature nearest to its middle and
// the one a day earlier; the first window uses the day before it, else the
// forward difference, else the file is refused as too short (A14).

#ifndef KG_CORE_MISSION_INGEST_H_
#define KG_CORE_MISSION_INGEST_H_

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "kg_core/mission/fact_update.h"
#include "kg_core/mission/mission.h"
#include "kg_core/raster/ocean_file.h"
#include "kg_core/raster/vector_field.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

// The kind of value layer that is |T(t) - T(t - 1 day)|; any other kind is the
// field itself.
inline constexpr char kDifferenceKind[] = "delta_sst";

// The rasters of files that facts refer to, by sha256; a file is read once,
// in a child process (ReadOceanFileSafely). Safe from any thread: two that want
// a new file at the same time may both read it, and get the same rasters.
class FileCache {
 public:
  // `data_folder`: where relative ex:file names are looked up first (launch
  // argument data:=), then `mission_folder`.
  FileCache(std::string mission_folder, std::string data_folder);

  // The absolute path of a file named by facts; throws InputError.
  std::string Resolve(const std::string& file) const;
  // Throws InputError (unreadable, truncated, missing variable, ...).
  std::shared_ptr<const OceanFile> Read(const std::string& path,
                                        const std::vector<Quantity>& wanted);

 private:
  std::string mission_folder_;
  std::string data_folder_;
  std::mutex mutex_;  // Held for looking up, not for reading.
  std::map<std::string, std::shared_ptr<const OceanFile>> files_;
};

// Stages the facts of every data source in `transaction`, and what the rules
// conclude from them. Returns the reasons
// why it cannot (too few days for the windows, all land, facts that violate a
// shape, ...); empty = done.
std::vector<std::string> StageIngest(FileCache& cache,
                                     Transaction& transaction);

// Does the transaction change what an ingest would read (a data source, a
// window's times), so that StageIngest is due?
bool IngestIsDue(const Transaction& transaction);

// StageUpdate (fact_update.h), and StageIngest if that is due then: all that
// can refuse an update but a mission that cannot be read.
struct StagedUpdate {
  Judgement judgement;
  double ingest_s = 0.0;  // Wall-clock, reading files.
};
StagedUpdate StageUpdateWithFiles(const FactUpdate& update, FileCache& cache,
                                  Transaction& transaction);

// The rasters behind the typed references. Throws InputError.
VectorField LoadWorkField(FileCache& cache, const Mission& mission,
                          const WorkFieldRef& field);
// On `grid`, resampled if the file's own grid differs (A54).
Raster LoadValueLayer(FileCache& cache, const Mission& mission,
                      const ValueLayer& layer, const Grid& grid);

}  // namespace kg_core

#endif  // KG_CORE_MISSION_INGEST_H_
