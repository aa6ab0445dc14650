#include "kg_base/raster/classic_length.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

constexpr std::size_t kMaxHeaderBytes = 16 << 20;
constexpr std::uint32_t kDimensionTag = 10;
constexpr std::uint32_t kVariableTag = 11;
constexpr std::uint32_t kAttributeTag = 12;
// Largest length accepted; prevents overflow of sums and products.
constexpr std::uint64_t kMaxLength = std::uint64_t{1} << 52;

std::uint64_t TimesSize(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product) || product > kMaxLength) {
    throw InputError("the header states an impossible file length");
  }
  return product;
}

std::uint64_t Padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

std::uint64_t TypeSize(std::uint64_t type) {
  static const std::uint64_t kSizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  if (type == 0 || type >= sizeof(kSizes) / sizeof(kSizes[0])) {
    throw InputError("the header names an unknown type");
  }
  return kSizes[type];
}

struct HeaderVariable {
  bool has_records = false;
  std::uint64_t bytes = 0;  // Size of the variable, or of one record of it.
  std::uint64_t type_bytes = 0;
  std::uint64_t begin = 0;
};

class HeaderParser {
 public:
  explicit HeaderParser(std::string_view bytes) : bytes_(bytes) {
    version_ = static_cast<unsigned char>(bytes_[3]);
    at_ = 4;
  }

  std::uint64_t Length() {
    const std::uint64_t records = Size();
    ReadDimensions();
    SkipAttributes();
    std::vector<HeaderVariable> variables(Count(kVariableTag));
    for (HeaderVariable& variable : variables) variable = ReadVariable();
    return End(variables, records);
  }

 private:
  std::uint64_t Integer(int bytes);
  // Counts and lengths: 8 bytes in CDF-5; file offsets: 4 in CDF-1 only.
  std::uint64_t Size() { return Integer(version_ == 5 ? 8 : 4); }
  std::uint64_t Offset() { return Integer(version_ == 1 ? 4 : 8); }
  std::uint64_t Count(std::uint32_t tag);
  void Skip(std::uint64_t bytes);
  void SkipName() { Skip(Padded(Size())); }
  void SkipAttributes();
  void ReadDimensions();
  HeaderVariable ReadVariable();
  std::uint64_t End(const std::vector<HeaderVariable>& variables,
                    std::uint64_t records) const;
  bool IsStreaming(std::uint64_t records) const {
    return records == (version_ == 5 ? ~std::uint64_t{0} : 0xffffffffu);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  int version_ = 1;
  std::vector<std::uint64_t> dimensions_;  // 0: the record dimension.
};

void HeaderParser::Skip(std::uint64_t bytes) {
  if (bytes > bytes_.size() - at_) {
    throw InputError("the file ends within its header");
  }
  at_ += static_cast<std::size_t>(bytes);
}

std::uint64_t HeaderParser::Integer(int bytes) {
  const std::size_t begin = at_;
  Skip(static_cast<std::uint64_t>(bytes));
  std::uint64_t value = 0;
  for (std::size_t i = begin; i < at_; ++i) {
    value = value << 8 | static_cast<unsigned char>(bytes_[i]);
  }
  return value;
}

// Reads the tag and the length of a list, both 0 if it is absent. Each entry
// takes more than a byte of the header, so longer lists are invalid.
std::uint64_t HeaderParser::Count(std::uint32_t tag) {
  const std::uint64_t found = Integer(4);
  const std::uint64_t count = Size();
  if ((found != tag && (found != 0 || count != 0)) ||
      count > bytes_.size() - at_) {
    throw InputError("the header is damaged");
  }
  return count;
}

void HeaderParser::SkipAttributes() {
  for (std::uint64_t n = Count(kAttributeTag); n > 0; --n) {
    SkipName();
    const std::uint64_t type_bytes = TypeSize(Integer(4));
    Skip(Padded(TimesSize(Size(), type_bytes)));
  }
}

void HeaderParser::ReadDimensions() {
  for (std::uint64_t n = Count(kDimensionTag); n > 0; --n) {
    SkipName();
    dimensions_.push_back(Size());
  }
}

HeaderVariable HeaderParser::ReadVariable() {
  HeaderVariable variable;
  SkipName();
  std::uint64_t values = 1;
  const std::uint64_t rank = Size();
  for (std::uint64_t i = 0; i < rank; ++i) {
    const std::uint64_t dimension = Size();
    if (dimension >= dimensions_.size()) {
      throw InputError("the header names a dimension that it does not have");
    }
    const std::uint64_t size = dimensions_[dimension];
    if (i == 0 && size == 0) {
      variable.has_records = true;
    } else {
      values = TimesSize(values, size);
    }
  }
  SkipAttributes();
  variable.type_bytes = TypeSize(Integer(4));
  variable.bytes = TimesSize(values, variable.type_bytes);
  Size();  // vsize, redundant and capped for large variables.
  variable.begin = TimesSize(Offset(), 1);
  return variable;
}

// A single record variable is not padded between its records.
std::uint64_t HeaderParser::End(const std::vector<HeaderVariable>& variables,
                                std::uint64_t records) const {
  // One record holds a slice of every record variable, padded to 4 bytes.
  std::uint64_t record_bytes = 0;
  std::uint64_t record_variables = 0;
  for (const HeaderVariable& variable : variables) {
    if (!variable.has_records) continue;
    record_bytes += Padded(variable.bytes);
    ++record_variables;
  }
  // The file ends at the end of its last variable, or with the header.
  std::uint64_t end = at_;
  for (const HeaderVariable& variable : variables) {
    std::uint64_t bytes = variable.bytes;
    if (variable.has_records) {
      if (IsStreaming(records)) {
        throw InputError("the header does not say how many records there are");
      }
      if (records == 0) continue;
      const std::uint64_t step =
          record_variables == 1 ? variable.bytes : record_bytes;
      bytes += TimesSize(records - 1, step);
    }
    end = std::max(end, variable.begin + bytes);
  }
  return end;
}

}  // namespace

std::optional<std::uint64_t> ClassicLength(std::string_view header) {
  if (header.size() < 4 || header.substr(0, 3) != "CDF") return std::nullopt;
  if (header[3] != 1 && header[3] != 2 && header[3] != 5) return std::nullopt;
  return HeaderParser(header).Length();
}

void CheckClassicLength(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw InputError(path + ": cannot be read");
  const std::uint64_t length = static_cast<std::uint64_t>(file.tellg());
  std::string header(std::min<std::uint64_t>(length, kMaxHeaderBytes), '\0');
  file.seekg(0);
  file.read(&header[0], static_cast<std::streamsize>(header.size()));
  if (!file) throw InputError(path + ": cannot be read");
  try {
    const std::optional<std::uint64_t> promised = ClassicLength(header);
    if (!promised || length >= *promised) return;
    throw InputError("truncated: its header states " +
                     std::to_string(*promised) + " bytes, it has " +
                     std::to_string(length));
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace kg_base
