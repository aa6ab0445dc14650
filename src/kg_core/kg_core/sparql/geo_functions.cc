// GeoSPARQL's simple feature relations and distance on geo:wktLiteral.
// https://docs.ogc.org/is/22-047r1/22-047r1.html (Annex: functions)
//
// Relations are planar, in longitude and latitude (degrees). geof:distance
// takes its unit as third argument: uom:degree is planar; uom:metre is geodesic
// and defined between points only.

#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/geo/geodesy.h"
#include "kg_base/geo/wkt.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/functions.h"

namespace kg_core::sparql {
namespace {

using kg_base::Geometry;

constexpr std::size_t kCachedGeometries = 10000;

// The geometry of a literal, parsed once per query; nullptr if it is not one.
const Geometry* GetGeometry(FunctionContext& context, const Term& term) {
  const bool typed = term.datatype == std::string(kGeo) + "wktLiteral" ||
                     term.datatype == std::string(kXsd) + "string";
  if (!term.is_literal() || !typed) return nullptr;
  const auto known = context.geometries.find(term.text);
  if (known != context.geometries.end()) return known->second.get();
  std::shared_ptr<const Geometry> geometry;
  try {
    geometry = std::make_shared<const Geometry>(Geometry::FromWkt(term.text));
  } catch (const kg_base::InputError&) {
    geometry = nullptr;  // Not a geometry: cached as an error too.
  }
  return context.geometries.emplace(term.text, std::move(geometry))
      .first->second.get();
}

struct GeometryPair {
  const Geometry* a = nullptr;
  const Geometry* b = nullptr;
  explicit operator bool() const { return a != nullptr && b != nullptr; }
};

GeometryPair GetGeometries(FunctionContext& context,
                           const Arguments& arguments) {
  if (context.geometries.size() + 2 > kCachedGeometries) {
    context.geometries.clear();
  }
  return {GetGeometry(context, *arguments[0]),
          GetGeometry(context, *arguments[1])};
}

Answer Intersects(FunctionContext& context, const Arguments& arguments) {
  const GeometryPair pair = GetGeometries(context, arguments);
  if (!pair) return std::nullopt;
  return BooleanLiteral(pair.a->Intersects(*pair.b));
}

Answer Disjoint(FunctionContext& context, const Arguments& arguments) {
  const GeometryPair pair = GetGeometries(context, arguments);
  if (!pair) return std::nullopt;
  return BooleanLiteral(!pair.a->Intersects(*pair.b));
}

Answer Within(FunctionContext& context, const Arguments& arguments) {
  const GeometryPair pair = GetGeometries(context, arguments);
  if (!pair) return std::nullopt;
  return BooleanLiteral(pair.a->Within(*pair.b));
}

Answer GeometryContains(FunctionContext& context, const Arguments& arguments) {
  const GeometryPair pair = GetGeometries(context, arguments);
  if (!pair) return std::nullopt;
  return BooleanLiteral(pair.b->Within(*pair.a));
}

Answer Distance(FunctionContext& context, const Arguments& arguments) {
  const GeometryPair pair = GetGeometries(context, arguments);
  if (!pair) return std::nullopt;
  const std::string uom = "http://www.opengis.net/def/uom/OGC/1.0/";
  const std::string& unit = arguments[2]->text;
  if (unit == uom + "degree") {
    return DoubleLiteral(pair.a->DistanceDegrees(*pair.b));
  }
  if (unit != uom + "metre" || !pair.a->IsPoint() || !pair.b->IsPoint()) {
    return std::nullopt;
  }
  return DoubleLiteral(kg_base::Distance_m(pair.a->Point(), pair.b->Point()));
}

}  // namespace

std::vector<SparqlFunction> GeoFunctions() {
  const std::string geof(kGeof);
  return {{geof + "sfIntersects", 2, 2, Intersects},
          {geof + "sfDisjoint", 2, 2, Disjoint},
          {geof + "sfWithin", 2, 2, Within},
          {geof + "sfContains", 2, 2, GeometryContains},
          {geof + "distance", 3, 3, Distance}};
}

}  // namespace kg_core::sparql
