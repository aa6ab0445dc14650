// From facts in Turtle and files on disk to tensors: rasters of priors, masks,
// other grids, and policies of every kind, through the compiler's public
// interface.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/raster/field_child.h"
#include "kg_base/raster/testing/test_raster_file.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_vocabulary.h"

namespace kg_compiler {
namespace {

using kg_base::Grid;
using kg_base::Raster;

// Two days off Tampico. `plain` and `paper` weigh the prior, `fixed` does not.
constexpr char kFacts[] = R"ttl(
ex:m a ex:Mission ; ex:name "files" ; ex:hasWindow ex:w0 , ex:w1 ;
    ex:hasAgent ex:alpha , ex:bravo , ex:charlie ; ex:waypointSpacingKm 8 .
ex:currents a ex:DataSource ; ex:file "CURRENTS" ; ex:provides "current" .
ex:sst a ex:DataSource ; ex:file "SST" ; ex:provides "temperature" ;
    ex:fullScale 2 ; ex:frontFullScale 0.2 .
ex:slope a ex:DataSource ; ex:file "SST" ; ex:provides "temperature" ;
    ex:kind "frontness" .
ex:w0 a ex:TimeWindow ; ex:index 0 ; ex:confidence 1 ; ex:durationHours 24 ;
    time:hasBeginning "2020-11-03T00:00:00Z"^^xsd:dateTime .
ex:w1 a ex:TimeWindow ; ex:index 1 ; ex:confidence 0.8 ; ex:durationHours 24 ;
    time:hasBeginning "2020-11-04T00:00:00Z"^^xsd:dateTime .
ex:land a ex:Constraint ; ex:kind "no_go" ; ex:gridRef "land" .
ex:habitat a ex:PriorLayer ; ex:name "habitat" ;
    ex:gridRef "habitat.nc#slant" ; ex:resampling "bilinear" .
ex:farm a ex:Constraint ; ex:kind "no_go" ; ex:gridRef "habitat.nc#farm" ;
    ex:resampling "nearest" ; ex:bufferCells 1 ; ex:bufferMetric "chebyshev" .
ex:quiet a ex:Constraint ; ex:kind "soft" ; ex:attenuation 0.5 ;
    ex:gridRef "habitat.nc#farm" ; ex:resampling "nearest" ;
    ex:appliesTo ex:charlie ; ex:appliesIn ex:w1 .
ex:plain a ex:Policy ; ex:alpha_base 1 ; ex:gamma_front 0.5 ;
    ex:priors '{"habitat": -0.25}' .
ex:paper a ex:Policy ; ex:alpha_base 1 ; ex:gamma_front 0.5 ;
    ex:priors '{"habitat": -0.25}' ; ex:paperLiteral true .
ex:fixed a ex:Policy ; ex:alpha_base 1 ; ex:gamma_front 0.5 ;
    ex:layerScale "fixed" ; ex:frontOperator "central" ;
    ex:softOverlap "min" .
ex:alpha a ex:Agent ; ex:id "alpha" ; ex:usesPolicy ex:plain ;
    ex:hasCapabilities ex:can .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:usesPolicy ex:paper ;
    ex:hasCapabilities ex:can .
ex:charlie a ex:Agent ; ex:id "charlie" ; ex:usesPolicy ex:fixed ;
    ex:hasCapabilities ex:can .
ex:can a ex:AgentCapabilities ; ex:cruiseSpeedKts 1 ; ex:maxSpeedKts 1.5 ;
    ex:energyPerKm 2 ; ex:energyBudget 500 ; ex:sensorRadiusKm 12 .
ex:a0 a ex:AgentState ; ex:forAgent ex:alpha ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-97 22)" .
ex:b0 a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-97 22.1)" .
ex:c0 a ex:AgentState ; ex:forAgent ex:charlie ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-97 22.2)" .
)ttl";

// Linear in position, so that bilinear resampling reproduces it exactly.
double Slant(kg_base::LonLat p) {
  return 0.5 * (p.lon_deg + 97.0) + 0.25 * (p.lat_deg - 22.0);
}
// By more than 1 % of the smaller of the two cells.
bool Overlap(const kg_base::Axis& one, int i, const kg_base::Axis& other,
             int k) {
  const double width = std::min(one.Edge(i + 1), other.Edge(k + 1)) -
                       std::max(one.Edge(i), other.Edge(k));
  return width > 0.01 * std::min(one.Edge(i + 1) - one.Edge(i),
                                 other.Edge(k + 1) - other.Edge(k));
}

// Farms are blocks of two by two cells of the habitat, in open water in both
// test oceans.
bool IsFarm(const Grid& habitat, kg_base::Cell cell) {
  const int row = cell.row / 2 - habitat.rows() / 4;
  const int col = cell.col / 2 - 3 * habitat.cols() / 8;
  return row >= 0 && row < 4 && col >= 0 && col < 2;
}

std::string Replaced(std::string text, const std::string& what,
                     const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos;) {
    text.replace(at, what.size(), by);
    at += by.size();
  }
  return text;
}

// An ocean to compile: its files and their grid.
struct Ocean {
  std::string currents;
  std::string sst;
  Grid grid;
};

class CompileFromFiles : public testing::Test {
 protected:
  // 21 x 16 cells with a coast in the west; a warm tongue that moves.
  Ocean MadeUp() const {
    std::vector<double> lon_deg, lat_deg, hours;
    for (int i = 0; i < 16; ++i) lon_deg.push_back(-97.3 + 0.04 * i);
    for (int i = 0; i < 21; ++i) lat_deg.push_back(21.6 + 0.04 * i);
    const Grid grid(lon_deg, lat_deg);
    std::vector<Raster> flow, warmth;
    for (int day = 0; day < 6; ++day) {
      hours.push_back(kHoursTo2020 + 24.0 * day);
      flow.emplace_back();
      warmth.emplace_back();
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const int row = static_cast<int>(i) / grid.cols();
        const int col = static_cast<int>(i) % grid.cols();
        const bool land = col == 0;
        flow.back().push_back(land ? NAN : 0.2f + 0.01f * day);
        warmth.back().push_back(
            land ? NAN : 25.0f + std::sin(0.3f * row + 0.5f * col + day));
      }
    }
    kg_base::TestRasterFileWriter(
        folder_ / "ocean.nc",
        {grid,
         hours,
         {{"u", "eastward_sea_water_velocity", "m/s", flow},
          {"v", "northward_sea_water_velocity", "m/s", flow},
          {"t", "sea_surface_temperature", "degC", warmth}}});
    return {"ocean.nc", "ocean.nc", grid};
  }

  static std::optional<Ocean> Real() {
    const char* folder = std::getenv("KG_SHARED_DATA");
    const std::string path =
        std::string(folder ? folder : "../../../shared/data") + "/gom_2020/";
    Ocean ocean{path + "currents_hycom_gomu_2020-11-01-15_5h.nc4",
                path + "sst_borrowed_2020-11-01-15_daily.nc",
                {}};
    if (!std::ifstream(ocean.currents) || !std::ifstream(ocean.sst)) return {};
    ocean.currents = std::filesystem::absolute(ocean.currents).string();
    ocean.sst = std::filesystem::absolute(ocean.sst).string();
    ocean.grid =
        kg_base::ReadFieldFileSafely(
            ocean.currents, {kg_base::FieldQuantity::kEastwardVelocity,
                             kg_base::FieldQuantity::kNorthwardVelocity})
            .grid;
    return ocean;
  }

  // Writes the prior and the mask on a shifted grid with cells half as large
  // that leaves the two northern rows of the ocean uncovered.
  void WriteHabitat(const Grid& ocean) {
    std::vector<double> lon_deg, lat_deg;
    const double step = 0.5 * (ocean.lon_deg()[1] - ocean.lon_deg()[0]);
    for (int i = 0; i < 2 * ocean.cols() + 4; ++i) {
      lon_deg.push_back(ocean.lon_deg()[0] + step * (i - 1.7));
    }
    const int rows = ocean.rows() - 2;
    for (int i = 0; i < 2 * rows; ++i) {
      lat_deg.push_back(ocean.lat_deg()[0] + step * (i - 0.7));
    }
    habitat_ = Grid(lon_deg, lat_deg);
    Raster slant, farm;
    for (int row = 0; row < habitat_.rows(); ++row) {
      for (int col = 0; col < habitat_.cols(); ++col) {
        slant.push_back(static_cast<float>(Slant(habitat_.Centre({row, col}))));
        farm.push_back(IsFarm(habitat_, {row, col}) ? 1.0f : 0.0f);
      }
    }
    kg_base::TestRasterFileWriter(
        folder_ / "habitat.nc",
        {habitat_,
         {},
         {{"slant", "", "", {slant}, false}, {"farm", "", "", {farm}, false}}});
  }

  void Prepare(const Ocean& ocean) {
    WriteHabitat(ocean.grid);
    facts_ = Replaced(Replaced(kFacts, "CURRENTS", ocean.currents), "SST",
                      ocean.sst);
    kg_core::Transaction transaction = store_->Begin();
    kg_mission::StageVocabulary("../kg_mission/ontology", transaction);
    transaction.Commit(kg_core::WorldChange::kYes);
  }

  std::vector<std::string> Update(const kg_core::FactUpdate& update) {
    kg_core::Transaction transaction = store_->Begin();
    const kg_mission::StagedUpdate staged =
        StageUpdateWithFiles(update, *files_, transaction);
    if (staged.judgement.reasons.empty()) {
      transaction.Commit(kg_core::WorldChange::kYes);
    }
    return staged.judgement.reasons;
  }
  std::string Add(const std::string& turtle) {
    kg_core::FactUpdate update;
    update.turtle = turtle;
    std::string lines;
    for (const std::string& line : Update(update)) lines += line + "\n";
    return lines;
  }

  std::shared_ptr<const Compilation> Compile() {
    mission_ = kg_mission::ReadMission(*store_->Read());
    return compiler_->Compile(mission_, ++version_, 0);
  }

  const MissionTensor& Tensor(const Compilation& compilation,
                              const std::string& agent, int window) const {
    for (const auto& tensor : compilation.tensors) {
      if (tensor->agent_iri == kg_core::Ex(agent).text &&
          tensor->window == window) {
        return *tensor;
      }
    }
    throw std::logic_error("no such tensor");
  }

  static bool Cites(const MissionTensor& tensor, const std::string& name) {
    return std::count(tensor.derived_from.begin(), tensor.derived_from.end(),
                      kg_core::Ex(name).text) == 1;
  }

  // Does the habitat cell that contains the centre of `cell` belong to a farm?
  bool InFarm(const Grid& grid, kg_base::Cell cell) const {
    if (!grid.Contains(cell)) return false;
    const auto own = habitat_.CellAt(grid.Centre(cell));
    return own && IsFarm(habitat_, *own);
  }
  // Does any habitat cell that overlaps `cell` belong to a farm?
  bool TouchesFarm(const Grid& grid, kg_base::Cell cell) const {
    if (!grid.Contains(cell)) return false;
    for (int row = 0; row < habitat_.rows(); ++row) {
      if (!Overlap(habitat_.lat_axis(), row, grid.lat_axis(), cell.row)) {
        continue;
      }
      for (int col = 0; col < habitat_.cols(); ++col) {
        if (IsFarm(habitat_, {row, col}) &&
            Overlap(habitat_.lon_axis(), col, grid.lon_axis(), cell.col)) {
          return true;
        }
      }
    }
    return false;
  }
  bool NearFarm(const Grid& grid, kg_base::Cell cell) const {
    for (int row = -1; row <= 1; ++row) {
      for (int col = -1; col <= 1; ++col) {
        if (TouchesFarm(grid, {cell.row + row, cell.col + col})) return true;
      }
    }
    return false;
  }

  void CheckTensors(const Ocean& ocean);
  void CheckSources(const Compilation& compilation) const;

  static constexpr double kHoursTo2020 = -24.0 * 2038 + 12.0;  // 2020-11-01.

  kg_base::TemporaryFolder folder_;
  Grid habitat_;
  std::string facts_;
  std::unique_ptr<kg_core::Store> store_ = std::make_unique<kg_core::Store>("");
  std::unique_ptr<kg_mission::FileCache> files_ =
      std::make_unique<kg_mission::FileCache>(folder_ / "", "");
  std::unique_ptr<MissionCompiler> compiler_ =
      std::make_unique<MissionCompiler>(files_.get());
  kg_mission::Mission mission_;
  std::uint64_t version_ = 0;
};

void CompileFromFiles::CheckSources(const Compilation& compilation) const {
  for (const int window : {0, 1}) {
    const std::string name = std::to_string(window);
    for (const char* agent : {"alpha", "bravo", "charlie"}) {
      const MissionTensor& tensor = Tensor(compilation, agent, window);
      const bool weighs = std::string(agent) != "charlie";
      EXPECT_EQ(Cites(tensor, "habitat"), weighs) << agent;
      EXPECT_EQ(Cites(tensor, "habitat/file"), weighs) << agent;
      EXPECT_TRUE(Cites(tensor, "farm")) << agent;
      EXPECT_TRUE(Cites(tensor, "farm/file")) << agent;
      EXPECT_EQ(Cites(tensor, "quiet"), !weighs && window == 1) << agent;
      EXPECT_TRUE(Cites(tensor, "sst/w" + name)) << agent;
      EXPECT_TRUE(Cites(tensor, "sst/file")) << agent;
      EXPECT_FALSE(Cites(tensor, "slope/file")) << agent;
    }
  }
}

void CompileFromFiles::CheckTensors(const Ocean& ocean) {
  const auto compilation = Compile();
  CheckSources(*compilation);
  for (const int window : {0, 1}) {
    const MissionTensor& tensor = Tensor(*compilation, "alpha", window);
    const MissionTensor& paper = Tensor(*compilation, "bravo", window);
    const MissionTensor& fixed = Tensor(*compilation, "charlie", window);
    EXPECT_NE(tensor.hash, paper.hash);
    ASSERT_TRUE(tensor.grid.AlmostEquals(ocean.grid));
    const Raster feasible = tensor.Get(Layer::kFeasibility);
    const Raster policy = tensor.Get(Layer::kPolicy);
    const Raster fused = tensor.Get(Layer::kFused);
    const Raster soft = fixed.Get(Layer::kAttenuation);
    int closed = 0, outside = 0;
    for (std::size_t i = 0; i < tensor.grid.size(); ++i) {
      const kg_base::Cell cell{static_cast<int>(i) / tensor.grid.cols(),
                               static_cast<int>(i) % tensor.grid.cols()};
      if (std::isnan(feasible[i])) continue;  // Land.
      const bool near = NearFarm(tensor.grid, cell);
      EXPECT_EQ(feasible[i], near ? 0.0f : 1.0f) << cell.row << " " << cell.col;
      if (near) {
        EXPECT_EQ(fused[i], 0.0f);
      }
      closed += near;
      const kg_base::LonLat place = tensor.grid.Centre(cell);
      const bool covered = place.lat_deg <= habitat_.north_deg();
      outside += !covered;
      const auto at = habitat_.Locate(place);
      if (!at) {
        EXPECT_EQ(policy[i], 0.0f);
      }
      // Skip places beyond the last centres, where the value is constant.
      if (!at || at->row > habitat_.rows() - 1.0) continue;
      EXPECT_NEAR(policy[i], -0.25 * Slant(place), 1e-5);
      const bool is_quiet = window == 1 && InFarm(tensor.grid, cell);
      EXPECT_NEAR(soft[i], is_quiet ? 0.5 : 1.0, 1e-6);
    }
    EXPECT_GT(closed, 5);
    EXPECT_GT(outside, 5);
  }
}

TEST_F(CompileFromFiles, RastersAndMasksReachTheTensors) {
  const Ocean ocean = MadeUp();
  Prepare(ocean);
  ASSERT_EQ(Add(facts_), "");
  CheckTensors(ocean);
}

TEST_F(CompileFromFiles, AlsoOnTheRealCurrentsOffTampico) {
  const std::optional<Ocean> ocean = Real();
  if (!ocean) GTEST_SKIP() << "no shared data folder gom_2020";
  Prepare(*ocean);
  ASSERT_EQ(Add(facts_), "");
  CheckTensors(*ocean);
}

// Which changes cause recompilation of which tensors.
TEST_F(CompileFromFiles, OnlyWhatIsReadChangesATensor) {
  Prepare(MadeUp());
  ASSERT_EQ(Add(facts_), "");
  const auto before = Compile();
  const auto changed = [&](const kg_core::Fact& fact) {
    kg_core::FactUpdate update;
    update.set = {fact};
    EXPECT_TRUE(Update(update).empty()) << fact.subject;
    std::string names;
    const auto after = Compile();
    for (const char* agent : {"alpha", "bravo", "charlie"}) {
      for (const int window : {0, 1}) {
        if (Tensor(*before, agent, window).hash ==
            Tensor(*after, agent, window).hash) {
          continue;
        }
        names += std::string(1, agent[0]) + std::to_string(window) + " ";
      }
    }
    return names;
  };
  const std::string all = "a0 a1 b0 b1 c0 c1 ";
  EXPECT_EQ(changed({"ex:habitat", "ex:resampling", "\"nearest\""}),
            "a0 a1 b0 b1 ");
  EXPECT_EQ(changed({"ex:habitat", "ex:resampling", "\"bilinear\""}), "");
  EXPECT_EQ(changed({"ex:farm", "ex:bufferMetric", "\"euclidean\""}), all);
  EXPECT_EQ(changed({"ex:farm", "ex:bufferMetric", "\"chebyshev\""}), "");
  EXPECT_EQ(changed({"ex:quiet", "ex:attenuation", "0.6"}), "c1 ");
  EXPECT_EQ(changed({"ex:quiet", "ex:attenuation", "0.5"}), "");
  EXPECT_EQ(changed({"ex:slope", "ex:fullScale", "9"}), "");
  EXPECT_EQ(changed({"ex:sst", "ex:fullScale", "4"}), "c0 c1 ");
  EXPECT_EQ(changed({"ex:sst", "ex:fullScale", "2"}), "");
  EXPECT_EQ(changed({"ex:fixed", "ex:frontOperator", "\"sobel\""}), "c0 c1 ");
  EXPECT_EQ(changed({"ex:fixed", "ex:frontOperator", "\"central\""}), "");
  EXPECT_EQ(changed({"ex:paper", "ex:paperLiteral", "false"}), "b0 b1 ");
  EXPECT_EQ(changed({"ex:plain", "ex:valueKind", "\"frontness\""}),
            "a0 a1 b0 b1 ");
}

struct Wrong {
  const char* what;
  const char* by;
  const char* said;
};
const Wrong kWrong[] = {
    {"ex:resampling \"bilinear\" ", "rdfs:label \"x\" ",
     "ex:habitat ex:resampling: expected \"nearest\", or \"bilinear\""},
    {"\"habitat.nc#slant\"", "\"habitat.nc#slope\"",
     "no variable \"slope\", expected one of slant, farm"},
    {"\"habitat.nc#slant\"", "\"habitat.nc#slant@1\"",
     "has 1 time steps, none with index 1"},
    {"\"habitat.nc#slant\"", "\"gone.nc#slant\"", "file \"gone.nc\" not found"},
    {"ex:gridRef \"land\"", "ex:gridRef \"sea\"", "ex:land ex:gridRef"},
    {"ex:paperLiteral true", "ex:paperLiteral \"yes\"", "ex:paperLiteral"},
    {"ex:kind \"frontness\"", "ex:kind \"salt\"", "ex:slope ex:kind"},
};

TEST_F(CompileFromFiles, WrongFactsAreRefusedInALineEach) {
  Prepare(MadeUp());
  for (const Wrong& wrong : kWrong) {
    const std::string said = Add(Replaced(facts_, wrong.what, wrong.by));
    EXPECT_NE(said.find(wrong.said), std::string::npos)
        << wrong.by << ": " << said;
  }
  ASSERT_EQ(Add(facts_), "");
}

TEST_F(CompileFromFiles, AMissingFixedScaleIsOneLine) {
  Prepare(MadeUp());
  ASSERT_EQ(Add(Replaced(facts_, "ex:frontFullScale 0.2", "rdfs:label \"\"")),
            "");
  try {
    Compile();
    ADD_FAILURE() << "compiled";
  } catch (const kg_base::InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "<http://example.org/mission/sst/w0> ex:frontFullScale: expected "
              "a number above 0, because policy ex:fixed has ex:layerScale "
              "\"fixed\"");
  }
}

}  // namespace
}  // namespace kg_compiler
