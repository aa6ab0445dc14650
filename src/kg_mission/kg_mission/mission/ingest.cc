#include "kg_mission/mission/ingest.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "kg_base/common/clock.h"
#include "kg_base/common/date_time.h"
#include "kg_base/common/input_error.h"
#include "kg_base/geo/geodesy.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/fact_writer.h"
#include "kg_core/facts/literals.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_mission/mission/conclusions.h"
#include "kg_mission/mission/data_quality.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/ingest_times.h"
#include "kg_mission/mission/ingested_facts.h"
#include "kg_mission/mission/layer_files.h"
#include "kg_mission/mission/layer_reader.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/mission_rules.h"
#include "kg_mission/mission/source_quantities.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_base::FieldFile;
using kg_base::Grid;
using kg_base::InputError;
using kg_base::Now_s;
using kg_base::Raster;
using kg_core::DoubleLiteral;
using kg_core::Ex;
using kg_core::IntegerLiteral;
using kg_core::Iri;
using kg_core::Literal;
using kg_core::Prov;
using kg_core::Term;
using kg_core::Transaction;

// Maximum samples per field: what rules and shapes can process within seconds.
constexpr std::size_t kMaxSamples = 10000;

bool HasData(const Raster& raster) {
  const auto is_number = [](float value) { return std::isfinite(value); };
  return std::any_of(raster.begin(), raster.end(), is_number);
}

bool HasData(const kg_base::QuantitySeries& series) {
  return std::any_of(series.at_time.begin(), series.at_time.end(),
                     [](const Raster& raster) { return HasData(raster); });
}

// The box of a grid on the globe. The outer edges of cells, half a cell beyond
// their centres, may lie beyond 180 degrees or a pole.
struct GlobeBox {
  double west_deg;
  double east_deg;
  double south_deg;
  double north_deg;
};

GlobeBox BoxOf(const Grid& grid) {
  // Less than a turn by the rounding of a file's coordinates.
  constexpr double kTurn_deg = 360.0 - 1e-6;
  GlobeBox box{
      std::max(grid.west_deg(), -180.0), std::min(grid.east_deg(), 180.0),
      std::max(grid.south_deg(), -90.0), std::min(grid.north_deg(), 90.0)};
  if (grid.east_deg() - grid.west_deg() >= kTurn_deg) {
    box.west_deg = -180.0;
    box.east_deg = 180.0;
  }
  return box;
}

std::string BoxWkt(const Grid& grid) {
  const GlobeBox box = BoxOf(grid);
  std::vector<double> lon_deg = {box.west_deg, box.east_deg};
  // An edge of more than half a turn, but not of a whole one, would be one that
  // crosses the antimeridian.
  const double width_deg = box.east_deg - box.west_deg;
  if (width_deg > 180.0 && width_deg < 360.0) {
    lon_deg.insert(lon_deg.begin() + 1, box.west_deg + width_deg / 2.0);
  }
  const auto vertex = [](double lon, double lat) {
    return DoubleLiteral(lon).text + " " + DoubleLiteral(lat).text;
  };
  std::string ring;
  for (const double lon : lon_deg) ring += vertex(lon, box.south_deg) + ", ";
  std::reverse(lon_deg.begin(), lon_deg.end());
  for (const double lon : lon_deg) ring += vertex(lon, box.north_deg) + ", ";
  return "POLYGON((" + ring + vertex(box.west_deg, box.south_deg) + "))";
}

double MeanRowKm(const Grid& grid) {
  const double lon_deg = grid.Middle().lon_deg;
  const GlobeBox box = BoxOf(grid);
  return kg_base::Distance_m({lon_deg, box.south_deg},
                             {lon_deg, box.north_deg}) /
         grid.rows() / 1000.0;
}

// The ingest of one data source: reads its files and states facts.
class SourceIngest {
 public:
  SourceIngest(const FactEntity& source, const Mission& mission,
               Transaction& transaction)
      : source_(source),
        name_(source.subject()),
        mission_(mission),
        transaction_(transaction),
        started_s_(Now_s()) {}

  // States the work field of each window (current or wind).
  void StateMotion(const FieldFile& file, const SourceQuantity& quantity) {
    RequireData(file);
    StateFile(file);
    StateGrid(Ex("grid"), file.grid);
    for (const TimeWindow& window : mission_.windows) {
      StateField(file, quantity, window, {"gridRefU", "gridRefV"}, Ex("grid"));
    }
    StateActivity();
  }

  // States a cost field: a scalar whose time integral along a flight is a seam
  // cost term.
  void StateCost(const FieldFile& file, const SourceQuantity& quantity,
                 const Grid* field_grid) {
    RequireData(file);
    StateFile(file);
    const Term grid = StateGridUnlessSame(file.grid, field_grid);
    for (const TimeWindow& window : mission_.windows) {
      const Term field = StateField(file, quantity, window, {"gridRef"}, grid);
      const std::optional<Term> said = source_.One(Ex("resampling"));
      if (said) Say(field, Ex("resampling"), *said);
    }
    StateActivity();
  }

  // `field_grid`: grid of the currents, null if there are none.
  void StateTemperature(const FieldFile& file, const Grid* field_grid) {
    RequireData(file);
    StateFile(file);
    const Term grid = StateGridUnlessSame(file.grid, field_grid);
    for (const TimeWindow& window : mission_.windows) {
      const Term layer = Part("w" + std::to_string(window.index));
      StateLayer(file, window, layer);
      Say(layer, Ex("onGrid"), grid);
      for (const char* name : {"resampling", "fullScale", "frontFullScale"}) {
        const std::optional<Term> said = source_.One(Ex(name));
        if (said) Say(layer, Ex(name), *said);
      }
    }
    StateActivity();
  }

  // States the raster that a prior layer or a constraint names by ex:gridRef.
  void StateRaster(const FieldFile& file, const GridRef& ref,
                   const Grid* field_grid) {
    StepOf(file, ref);
    StateFile(file);
    StateGridUnlessSame(file.grid, field_grid);
    StateActivity();
  }

  // States one ex:CellSample per cell above a limit, from which rules can
  // derive events. Uses the file's own grid, which may differ from the
  // mission's.
  void StateSamples(const FieldFile& file, const GridRef& ref, double above) {
    const Raster& values = StepOf(file, ref);
    StateFile(file);
    std::size_t count = 0;
    for (int row = 0; row < file.grid.rows(); ++row) {
      for (int col = 0; col < file.grid.cols(); ++col) {
        const double value = values[file.grid.Index({row, col})];
        if (!(value > above)) continue;  // Also skips no data (NaN).
        if (++count > kMaxSamples) {
          throw InputError("expected at most " + std::to_string(kMaxSamples) +
                           " cells above ex:sampleAbove");
        }
        StateSample(file.grid, {row, col}, value);
      }
    }
    StateActivity();
  }

 private:
  Term Part(const std::string& name) const {
    return Iri(name_.text + "/" + name);
  }

  void Say(const Term& subject, const Term& property, const Term& object) {
    transaction_.Add({subject, property, object, kg_core::Facts()});
  }

  // A file may have steps without data that no window needs.
  static void RequireStep(const FieldFile& file, int step,
                          const TimeWindow& window) {
    for (const kg_base::QuantitySeries& series : file.series) {
      if (HasData(series.at_time.at(step))) continue;
      throw InputError("variable " + series.variable +
                       ": no value in any cell at " +
                       kg_base::FormatDateTime(file.time_s.at(step)) +
                       ", expected some, because window " +
                       std::to_string(window.index) + " needs this time");
    }
  }

  // Throws InputError if the file has no such step or the step has no data.
  static const Raster& StepOf(const FieldFile& file, const GridRef& ref) {
    const std::vector<Raster>& steps = file.series[0].at_time;
    if (!(ref.time_index < static_cast<int>(steps.size()))) {
      throw InputError(
          "variable " + ref.variable + " has " + std::to_string(steps.size()) +
          " time steps, none with index " + std::to_string(ref.time_index));
    }
    const Raster& step = steps[ref.time_index];
    if (!HasData(step)) {
      throw InputError("variable " + ref.variable + " has no data in step " +
                       std::to_string(ref.time_index));
    }
    return step;
  }

  void StateSample(const Grid& grid, kg_base::Cell cell, double value) {
    const Term sample = Part("cell/" + std::to_string(cell.row) + "_" +
                             std::to_string(cell.col));
    Generate(sample, "CellSample");
    Say(sample, kg_core::GeoTerm("asWKT"),
        kg_core::WktLiteral(kg_base::PointWkt(grid.Centre(cell))));
    Say(sample, Ex("cellValue"), DoubleLiteral(value));
  }

  static void RequireData(const FieldFile& file) {
    for (const kg_base::QuantitySeries& series : file.series) {
      if (HasData(series)) continue;
      throw InputError("variable " + series.variable +
                       " has no data in any cell: expected some");
    }
  }

  // States the grid unless it equals `field_grid`; returns its IRI.
  Term StateGridUnlessSame(const Grid& grid, const Grid* field_grid) {
    if (field_grid) {
      CheckGrids(name_.text, grid, *field_grid, ReadResampling(source_));
      if (grid.AlmostEquals(*field_grid)) return Ex("grid");
    }
    StateGrid(Part("grid"), grid);
    return Part("grid");
  }

  void Generate(const Term& entity, const char* type) {
    Say(entity, kg_core::RdfType(), Ex(type));
    Say(entity, Ex("ingestedFrom"), name_);
    generated_.push_back(entity);
  }

  void StateFile(const FieldFile& file) {
    Say(Part("file"), kg_core::RdfType(), Ex("SourceFile"));
    Say(Part("file"), Ex("ingestedFrom"), name_);
    Say(Part("file"), Ex("path"), Literal(file.path));
    Say(Part("file"), Ex("sha256"), Literal(file.sha256));
    StateQuality(file);
  }

  void StateQuality(const FieldFile& file) {
    for (std::size_t i = 0; i < file.series.size(); ++i) {
      const Term report = Part("quality/" + std::to_string(i));
      Generate(report, "DataQualityReport");
      Say(report, Prov("wasDerivedFrom"), Part("file"));
      StateDataQuality(report, file, file.series[i],
                       mission_.windows.front().begin_s, transaction_);
    }
  }

  void StateGrid(const Term& subject, const Grid& grid) {
    Generate(subject, "GridSpec");
    Say(subject, Ex("rows"), IntegerLiteral(grid.rows()));
    Say(subject, Ex("cols"), IntegerLiteral(grid.cols()));
    Say(subject, kg_core::GeoTerm("asWKT"), kg_core::WktLiteral(BoxWkt(grid)));
    Say(subject, Ex("pixelSizeKm"), DoubleLiteral(MeanRowKm(grid)));
    Say(subject, Prov("wasDerivedFrom"), Part("file"));
  }

  // States a field over a range of time steps; `refs` names its components in
  // order.
  Term StateField(const FieldFile& file, const SourceQuantity& quantity,
                  const TimeWindow& window,
                  const std::vector<const char*>& refs, const Term& grid) {
    const StepRange steps = StepsOfField(file.time_s, window);
    for (int step = steps.first; step <= steps.last; ++step) {
      RequireStep(file, step, window);
    }
    const Term field = Part("w" + std::to_string(window.index));
    const std::string at =
        "@" + std::to_string(steps.first) + ".." + std::to_string(steps.last);
    Generate(field, quantity.layer_class.c_str());
    Say(field, Ex("forWindow"), Iri(window.iri));
    for (std::size_t i = 0; i < refs.size(); ++i) {
      Say(field, Ex(refs[i]),
          Literal(file.path + "#" + file.series[i].variable + at));
    }
    Say(field, Ex("firstTimeIndex"), IntegerLiteral(steps.first));
    Say(field, Ex("lastTimeIndex"), IntegerLiteral(steps.last));
    Say(field, Ex("onGrid"), grid);
    Say(field, Iri(std::string(kg_core::kSosa) + "observedProperty"),
        Ex(quantity.observed_property));
    Say(field, Prov("wasDerivedFrom"), Part("file"));
    return field;
  }

  std::string Kind() const { return source_.Text(Ex("kind"), kDifferenceKind); }

  StepPair StepsOfLayer(const FieldFile& file, const TimeWindow& window) const {
    if (Kind() == kDifferenceKind) {
      return StepsOfDifference(file.time_s, window);
    }
    const int step = StepOfWindow(file.time_s, window);
    return {step, step};
  }

  void StateLayer(const FieldFile& file, const TimeWindow& window,
                  const Term& layer) {
    const StepPair steps = StepsOfLayer(file, window);
    RequireStep(file, steps.step, window);
    RequireStep(file, steps.previous, window);
    Generate(layer, "ValueLayer");
    Say(layer, Ex("forWindow"), Iri(window.iri));
    Say(layer, Ex("kind"), Literal(Kind()));
    Say(layer, Ex("timeIndex"), IntegerLiteral(steps.step));
    Say(layer, Iri(std::string(kg_core::kSosa) + "resultTime"),
        kg_core::DateTimeLiteral(file.time_s.at(steps.step)));
    std::string at = "@" + std::to_string(steps.step);
    if (steps.previous != steps.step) {
      Say(layer, Ex("previousTimeIndex"), IntegerLiteral(steps.previous));
      at += "," + std::to_string(steps.previous);
    }
    Say(layer, Ex("gridRef"),
        Literal(file.path + "#" + file.series[0].variable + at));
    Say(layer, Prov("wasDerivedFrom"), Part("file"));
  }

  void StateActivity() {
    const auto number =
        static_cast<long long>(transaction_.view().world_version() + 1);
    const std::string version = std::to_string(number);
    const std::string name =
        name_.text.substr(name_.text.find_last_of("/#") + 1);
    const Term activity =
        Iri(kg_core::kProvGraph + ("/ingest/v" + version + "/" + name));
    kg_core::FactWriter prov(Iri(kg_core::kProvGraph));
    prov.Activity(activity, "Ingest", started_s_, Now_s())
        .Integer("worldVersion", number)
        .Used(name_)
        .Used(Part("file"));
    for (const Term& entity : generated_) {
      prov.About(activity).Add(Prov("generated"), entity);
      prov.About(entity).Add(Prov("wasGeneratedBy"), activity);
    }
    prov.AddTo(transaction_);
  }

  const FactEntity source_;
  const Term name_;
  const Mission& mission_;
  Transaction& transaction_;
  const double started_s_;
  std::vector<Term> generated_;
};

// Ingests all data sources, currents or wind first because they define the
// mission's grid, then the rasters of priors and constraints.
class MissionIngest {
 public:
  MissionIngest(FileCache& cache, Transaction& transaction)
      : cache_(cache),
        transaction_(transaction),
        mission_(ReadMission(transaction.view())) {}

  std::vector<std::string> Run() {
    // In table order: the motion field comes first and defines the grid.
    for (const SourceQuantity& quantity : SourceQuantities()) ReadAll(quantity);
    ForAll("PriorLayer", &MissionIngest::ReadRaster);
    ForAll("Constraint", &MissionIngest::ReadRaster);
    ForAll("SampledField", &MissionIngest::ReadSamples);
    return std::move(reasons_);
  }

 private:
  void ReadAll(const SourceQuantity& quantity) {
    for (const Term& term : kg_core::FindInstances(
             transaction_.view(), kg_core::kFactsGraph, Ex("DataSource"))) {
      const FactEntity source(transaction_.view(), term);
      if (source.Text(Ex("provides")) != quantity.name) continue;
      Try(source, [&] { ReadSource(source, quantity); });
    }
  }

  void ForAll(const char* type,
              void (MissionIngest::*read)(const FactEntity&)) {
    for (const Term& term : kg_core::FindInstances(
             transaction_.view(), kg_core::kFactsGraph, Ex(type))) {
      const FactEntity layer(transaction_.view(), term);
      Try(layer, [&] { (this->*read)(layer); });
    }
  }

  template <typename Read>
  void Try(const FactEntity& source, const Read& read) {
    try {
      read();
    } catch (const InputError& error) {
      reasons_.push_back(kg_core::ToTurtle(source.subject()) + ": " + file_ +
                         error.what());
    }
    file_.clear();
  }

  const FieldFile& Open(const FactEntity& source,
                        const std::vector<kg_base::FieldQuantity>& wanted) {
    const std::string path = cache_.Resolve(source.Text(Ex("file")));
    return Keep(path, cache_.Read(path, wanted));
  }

  const FieldFile& Keep(const std::string& path,
                        std::shared_ptr<const FieldFile> file) {
    open_.push_back(std::move(file));
    file_ = path + ": ";  // Prefix of reasons found after reading.
    return *open_.back();
  }

  void ReadSource(const FactEntity& source, const SourceQuantity& quantity) {
    const FieldFile& file = Open(source, quantity.components);
    SourceIngest ingest(source, mission_, transaction_);
    switch (quantity.role) {
      case FieldRole::kMotion:
        if (field_grid_ != nullptr) {
          source.Refuse(Ex("provides"),
                        "one source of \"current\" or \"wind\", not two");
        }
        CheckMedium(quantity, file.series.front());
        field_grid_ = &file.grid;
        return ingest.StateMotion(file, quantity);
      case FieldRole::kValue:
        return ingest.StateTemperature(file, field_grid_);
      case FieldRole::kCost:
        return ingest.StateCost(file, quantity, field_grid_);
    }
  }

  void ReadRaster(const FactEntity& layer) {
    const std::optional<GridRef> ref = ReadGridRef(layer);
    if (!ref) return;
    const std::string path = cache_.Resolve(ref->file);
    const FieldFile& file =
        Keep(path, cache_.ReadVariable(path, ref->variable));
    SourceIngest(layer, mission_, transaction_)
        .StateRaster(file, *ref, field_grid_);
  }

  void ReadSamples(const FactEntity& field) {
    const std::optional<GridRef> ref = ReadGridRef(field);
    if (!ref) field.Refuse(Ex("gridRef"), "a raster");
    const std::string path = cache_.Resolve(ref->file);
    const FieldFile& file =
        Keep(path, cache_.ReadVariable(path, ref->variable));
    SourceIngest(field, mission_, transaction_)
        .StateSamples(file, *ref, field.Number(Ex("sampleAbove")));
  }

  FileCache& cache_;
  Transaction& transaction_;
  const Mission mission_;
  const Grid* field_grid_ = nullptr;
  std::string file_;
  std::vector<std::shared_ptr<const FieldFile>> open_;
  std::vector<std::string> reasons_;
};

}  // namespace

std::vector<std::string> StageIngest(FileCache& cache,
                                     Transaction& transaction) {
  DropIngestedFacts(transaction);
  try {
    std::vector<std::string> reasons = MissionIngest(cache, transaction).Run();
    if (reasons.empty()) reasons = StageMissionRules(transaction);
    if (reasons.empty()) reasons = kg_core::Lines(ValidateChange(transaction));
    if (!reasons.empty()) return reasons;
    const kg_core::GraphView& view = transaction.view();
    return CheckConclusions(kg_core::Vocabulary(view), view);
  } catch (const InputError& error) {
    return {error.what()};
  }
}

std::vector<std::string> FindMissingFiles(const FileCache& cache,
                                          const kg_core::GraphView& view) {
  std::vector<std::string> missing;
  const auto look_for = [&](const FactEntity& entity, const std::string& file) {
    try {
      cache.Resolve(file);
    } catch (const InputError& error) {
      missing.push_back(kg_core::ToTurtle(entity.subject()) + ": " +
                        error.what());
    }
  };
  for (const Term& term :
       kg_core::FindInstances(view, kg_core::kFactsGraph, Ex("DataSource"))) {
    const FactEntity source(view, term);
    look_for(source, source.Text(Ex("file")));
  }
  for (const char* type : {"PriorLayer", "Constraint", "SampledField"}) {
    for (const Term& term :
         kg_core::FindInstances(view, kg_core::kFactsGraph, Ex(type))) {
      const FactEntity layer(view, term);
      const std::optional<GridRef> ref = ReadGridRef(layer);
      if (ref) look_for(layer, ref->file);
    }
  }
  return missing;
}

StagedUpdate StageUpdateWithFiles(const kg_core::FactUpdate& update,
                                  FileCache& cache, Transaction& transaction) {
  StagedUpdate staged;
  staged.judgement = JudgeUpdate(update, transaction);
  std::vector<std::string>& reasons = staged.judgement.reasons;
  if (!reasons.empty() || !IngestIsDue(transaction)) return staged;
  const double begin_s = Now_s();
  reasons = StageIngest(cache, transaction);
  staged.ingest_s = Now_s() - begin_s;
  return staged;
}

}  // namespace kg_mission
