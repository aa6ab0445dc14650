// Converts CF time axes, "<unit> since <date> [<time> [<zone>]]", to Unix time.
// Source: CF-1.8, section 4.4; UDUNITS-2 for the spellings.

#ifndef KG_BASE_RASTER_CF_TIME_H_
#define KG_BASE_RASTER_CF_TIME_H_

#include <string>

namespace kg_base {

// time_s = epoch_s + value * unit_s, Unix seconds.
struct CfTime {
  double epoch_s = 0.0;
  double unit_s = 1.0;
};

// Any unit of time that UDUNITS reads, except months and years, which have no
// fixed length; calendars standard, gregorian (Julian before 1582-10-15)
// and proleptic_gregorian, "" for standard. Throws InputError without a file
// name.
CfTime ParseCfTime(const std::string& units, const std::string& calendar);

}  // namespace kg_base

#endif  // KG_BASE_RASTER_CF_TIME_H_
