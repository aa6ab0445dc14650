#include "kg_base/raster/field_protocol.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

constexpr std::uint64_t kMagic = 0x31444c454946474bULL;  // "KGFIELD1"
constexpr std::uint32_t kContents = 1;
constexpr std::uint32_t kError = 2;
constexpr std::uint32_t kMaxAxisValues = 100000;
constexpr std::uint32_t kMaxSeries = 16;
constexpr std::uint32_t kMaxText = 64 * 1024;
constexpr std::uint32_t kMaxTexts = 1024;
constexpr std::size_t kReportCounts = 4;

struct MessageHead {
  std::uint64_t magic = kMagic;
  std::uint32_t kind = kContents;
  std::uint32_t rows = 0;
  std::uint32_t cols = 0;
  std::uint32_t times = 0;
  std::uint32_t series = 0;
  std::uint32_t reserved = 0;
};

void PutText(const std::string& text, const PutBytes& put) {
  const std::uint32_t size = static_cast<std::uint32_t>(text.size());
  put(&size, sizeof(size));
  put(text.data(), text.size());
}

void PutTexts(const std::vector<std::string>& texts, const PutBytes& put) {
  const std::uint32_t count = static_cast<std::uint32_t>(texts.size());
  put(&count, sizeof(count));
  for (const std::string& text : texts) PutText(text, put);
}

void PutReport(const VariableReport& report, const PutBytes& put) {
  PutTexts({report.quantity, report.variable, report.level, report.times,
            report.unit},
           put);
  const std::uint64_t counts[kReportCounts] = {
      report.cells, report.cells_without_data, report.impossible_values,
      report.outliers};
  put(counts, sizeof(counts));
  put(&report.issue_time_s, sizeof(report.issue_time_s));
  PutTexts(report.warnings, put);
}

void PutDoubles(const std::vector<double>& values, const PutBytes& put) {
  put(values.data(), values.size() * sizeof(double));
}

class MessageReader {
 public:
  MessageReader(const std::string& path, const GetBytes& get)
      : path_(path), get_(get) {}

  FieldFile Read() {
    MessageHead head;
    get_(&head, sizeof(head));
    if (head.magic != kMagic) Refuse();
    if (head.kind == kError) throw InputError(Text());
    CheckSizes(head);
    FieldFile file;
    file.path = path_;
    file.sha256 = Text();
    file.grid = ReadGrid(head);
    file.time_s = Doubles(head.times);
    for (std::uint32_t i = 0; i < head.series; ++i) {
      file.series.push_back(Series(head));
    }
    return file;
  }

 private:
  [[noreturn]] void Refuse() const {
    throw InputError(path_ +
                     ": the reading process sent invalid data, expected "
                     "the contents of a NetCDF file");
  }
  void CheckSizes(const MessageHead& head) const {
    const bool axes = head.rows >= 2 && head.rows <= kMaxAxisValues &&
                      head.cols >= 2 && head.cols <= kMaxAxisValues &&
                      head.times >= 1 && head.times <= kMaxAxisValues;
    const double values = 1.0 * head.rows * head.cols * head.times *
                          (head.series > 0 ? head.series : 1);
    if (head.kind != kContents || !axes || head.series > kMaxSeries ||
        values > static_cast<double>(kMaxFieldValues)) {
      Refuse();
    }
  }
  std::string Text() const {
    std::uint32_t size = 0;
    get_(&size, sizeof(size));
    if (size > kMaxText) Refuse();
    std::string text(size, '\0');
    get_(&text[0], size);
    return text;
  }
  std::vector<std::string> Texts() const {
    std::uint32_t count = 0;
    get_(&count, sizeof(count));
    if (count > kMaxTexts) Refuse();
    std::vector<std::string> texts;
    for (std::uint32_t i = 0; i < count; ++i) texts.push_back(Text());
    return texts;
  }
  VariableReport Report() const {
    const std::vector<std::string> texts = Texts();
    if (texts.size() != 5) Refuse();
    std::uint64_t counts[kReportCounts] = {};
    get_(counts, sizeof(counts));
    VariableReport report;
    report.quantity = texts[0];
    report.variable = texts[1];
    report.level = texts[2];
    report.times = texts[3];
    report.unit = texts[4];
    report.cells = counts[0];
    report.cells_without_data = counts[1];
    report.impossible_values = counts[2];
    report.outliers = counts[3];
    get_(&report.issue_time_s, sizeof(report.issue_time_s));
    report.warnings = Texts();
    return report;
  }
  std::vector<double> Doubles(std::size_t count) const {
    std::vector<double> values(count);
    get_(values.data(), count * sizeof(double));
    return values;
  }
  Grid ReadGrid(const MessageHead& head) const {
    std::vector<double> lon_deg = Doubles(head.cols);
    std::vector<double> lat_deg = Doubles(head.rows);
    try {
      return Grid(std::move(lon_deg), std::move(lat_deg));
    } catch (const std::logic_error&) {
      Refuse();
    }
  }
  QuantitySeries Series(const MessageHead& head) const {
    QuantitySeries series;
    std::uint32_t quantity = 0;
    get_(&quantity, sizeof(quantity));
    series.quantity = static_cast<FieldQuantity>(quantity);
    series.variable = Text();
    series.standard_name = Text();
    series.report = Report();
    for (std::uint32_t time = 0; time < head.times; ++time) {
      Raster raster(std::size_t{head.rows} * head.cols);
      get_(raster.data(), raster.size() * sizeof(float));
      for (const float value : raster) {
        if (std::isinf(value)) Refuse();
      }
      series.at_time.push_back(std::move(raster));
    }
    return series;
  }

  const std::string& path_;
  const GetBytes& get_;
};

}  // namespace

void WriteFieldFile(const FieldFile& file, const PutBytes& put) {
  MessageHead head;
  head.rows = static_cast<std::uint32_t>(file.grid.rows());
  head.cols = static_cast<std::uint32_t>(file.grid.cols());
  head.times = static_cast<std::uint32_t>(file.time_s.size());
  head.series = static_cast<std::uint32_t>(file.series.size());
  // Sizes come first: the reader checks them before any allocation.
  put(&head, sizeof(head));
  PutText(file.sha256, put);
  PutDoubles(file.grid.lon_deg(), put);
  PutDoubles(file.grid.lat_deg(), put);
  PutDoubles(file.time_s, put);
  for (const QuantitySeries& series : file.series) {
    const std::uint32_t quantity = static_cast<std::uint32_t>(series.quantity);
    put(&quantity, sizeof(quantity));
    PutText(series.variable, put);
    PutText(series.standard_name.substr(0, kMaxText), put);
    PutReport(series.report, put);
    for (const Raster& raster : series.at_time) {
      put(raster.data(), raster.size() * sizeof(float));
    }
  }
}

void WriteFieldError(const std::string& line, const PutBytes& put) {
  MessageHead head;
  head.kind = kError;
  put(&head, sizeof(head));
  PutText(line.substr(0, kMaxText), put);
}

FieldFile ReadFieldBytes(const std::string& path, const GetBytes& get) {
  return MessageReader(path, get).Read();
}

}  // namespace kg_base
