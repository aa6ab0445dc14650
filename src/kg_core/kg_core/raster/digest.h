// SHA-256 over plain values, for the hashes of grids and fields.

#ifndef KG_CORE_RASTER_DIGEST_H_
#define KG_CORE_RASTER_DIGEST_H_

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

struct evp_md_ctx_st;

namespace kg_core {

class Digest {
 public:
  Digest();
  // The bytes of the values as this machine holds them, their number first.
  template <typename Number>
  void Add(const std::vector<Number>& values) {
    const std::size_t count = values.size();
    AddBytes(&count, sizeof(count));
    AddBytes(values.data(), count * sizeof(Number));
  }
  void AddBytes(const void* bytes, std::size_t count);
  std::string Hex();  // Once, at the end.

 private:
  std::shared_ptr<evp_md_ctx_st> context_;
};

}  // namespace kg_core

#endif  // KG_CORE_RASTER_DIGEST_H_
