#include "kg_base/geo/geos.h"

#include <string>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

class GeosContext {
 public:
  GeosContext() : handle_(GEOS_init_r()) {
    GEOSContext_setErrorMessageHandler_r(handle_, &GeosContext::Keep, this);
  }
  ~GeosContext() { GEOS_finish_r(handle_); }
  GeosContext(const GeosContext&) = delete;
  GeosContext& operator=(const GeosContext&) = delete;

  GEOSContextHandle_t handle() const { return handle_; }
  const std::string& message() const { return message_; }

 private:
  static void Keep(const char* message, void* context) {
    static_cast<GeosContext*>(context)->message_ = message;
  }

  GEOSContextHandle_t handle_;
  std::string message_;
};

const GeosContext& ThisThreadsContext() {
  thread_local const GeosContext context;
  return context;
}

[[noreturn]] void Fail() {
  throw InputError("geometry: GEOS says: " + ThisThreadsContext().message());
}

GEOSCoordSequence* Sequence(const std::vector<LonLat>& chain) {
  static_assert(sizeof(LonLat) == 2 * sizeof(double), "x y x y ...");
  return GEOSCoordSeq_copyFromBuffer_r(
      Geos(), reinterpret_cast<const double*>(chain.data()),
      static_cast<unsigned>(chain.size()), 0, 0);
}

GeosGeometry Ring(const std::vector<LonLat>& chain) {
  return Owned(GEOSGeom_createLinearRing_r(Geos(), Sequence(chain)));
}

}  // namespace

GEOSContextHandle_t Geos() { return ThisThreadsContext().handle(); }

void GeosDeleter::operator()(GEOSGeometry* geometry) const {
  // Use a new context: the thread's may already be destroyed when static
  // objects are.
  GEOSContextHandle_t context = GEOS_init_r();
  GEOSGeom_destroy_r(context, geometry);
  GEOS_finish_r(context);
}

GeosGeometry Owned(GEOSGeometry* result) {
  if (result == nullptr) Fail();
  return GeosGeometry(result);
}

bool Answer(char result) {
  if (result != 0 && result != 1) Fail();
  return result == 1;
}

GeosGeometry GeosPoint(LonLat position) {
  return Owned(
      GEOSGeom_createPointFromXY_r(Geos(), position.lon_deg, position.lat_deg));
}

GeosGeometry GeosLine(const std::vector<LonLat>& chain) {
  return Owned(GEOSGeom_createLineString_r(Geos(), Sequence(chain)));
}

GeosGeometry GeosPolygon(const std::vector<std::vector<LonLat>>& rings) {
  GeosGeometry shell = Ring(rings.front());
  std::vector<GeosGeometry> holes;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    holes.push_back(Ring(rings[i]));
  }
  std::vector<GEOSGeometry*> raw;  // createPolygon takes them, also on error.
  for (GeosGeometry& hole : holes) raw.push_back(hole.release());
  return Owned(GEOSGeom_createPolygon_r(Geos(), shell.release(), raw.data(),
                                        static_cast<unsigned>(raw.size())));
}

double GeosArea(const GEOSGeometry* geometry) {
  double area = 0.0;
  if (GEOSArea_r(Geos(), geometry, &area) != 1) Fail();
  return area;
}

}  // namespace kg_base
