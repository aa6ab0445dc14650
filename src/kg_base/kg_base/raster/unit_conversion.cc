#include "kg_base/raster/unit_conversion.h"

#include <udunits2.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxUnitBytes = 100;

// UDUNITS reads "ms-1" as per millisecond, "C" as coulomb and "degree Celsius"
// as a product. What files mean by them follows only from the quantity: they
// are taken so where that can be converted.
struct UnitSpelling {
  const char* found;
  const char* meant;
};
constexpr UnitSpelling kOtherSpellings[] = {
    {"ms-1", "m s-1"},
    {"cms-1", "cm s-1"},
    {"degree Celsius", "degC"},
    {"degrees Celsius", "degC"},
    {"degrees C", "degC"},
    {"deg C", "degC"},
    {"C", "degC"},
    {"Kelvin", "kelvin"},
    {"hrs", "hour"},
    {"mins", "minute"},
    {"secs", "second"},
    {"msec", "millisecond"},
    {"msecs", "millisecond"},
};

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using UnitPointer = std::unique_ptr<ut_unit, FreeUnit>;
using ConverterPointer = std::unique_ptr<cv_converter, FreeConverter>;

ut_system* UnitSystem() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);  // Would write to stderr.
    return ut_read_xml(nullptr);
  }();
  if (system == nullptr) {
    throw InputError("the database of units of UDUNITS cannot be read");
  }
  return system;
}

std::optional<UnitScale> Convert(const std::string& from,
                                 const std::string& to) {
  if (from.empty() || from.size() > kMaxUnitBytes) return std::nullopt;
  ut_system* const system = UnitSystem();
  const UnitPointer source(ut_parse(system, from.c_str(), UT_UTF8));
  const UnitPointer target(ut_parse(system, to.c_str(), UT_UTF8));
  if (!source || !target ||
      ut_are_convertible(source.get(), target.get()) == 0) {
    return std::nullopt;
  }
  const ConverterPointer converter(
      ut_get_converter(source.get(), target.get()));
  if (!converter) return std::nullopt;
  const double offset = cv_convert_double(converter.get(), 0.0);
  const double scale = cv_convert_double(converter.get(), 1.0) - offset;
  // A logarithmic or reciprocal unit has no such line.
  const double at_ten = cv_convert_double(converter.get(), 10.0);
  const double line = 10.0 * scale + offset;
  const bool affine = std::abs(at_ten - line) <= 1e-9 * (1 + std::abs(line));
  if (!affine || scale == 0.0) return std::nullopt;
  return UnitScale{scale, offset};
}

}  // namespace

std::optional<UnitScale> ConvertUnit(const std::string& from,
                                     const std::string& to) {
  static std::mutex mutex;  // The parser of UDUNITS has global state.
  const std::lock_guard<std::mutex> lock(mutex);
  if (from == to) return UnitScale{};
  const auto other = std::find_if(
      std::begin(kOtherSpellings), std::end(kOtherSpellings),
      [&](const UnitSpelling& spelling) { return from == spelling.found; });
  if (other != std::end(kOtherSpellings)) {
    const std::optional<UnitScale> scale = Convert(other->meant, to);
    if (scale) return scale;
  }
  return Convert(from, to);
}

}  // namespace kg_base
