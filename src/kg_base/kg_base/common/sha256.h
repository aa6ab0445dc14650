// SHA-256 (FIPS 180-4, by OpenSSL) of bytes, files and sequences of values.

#ifndef KG_BASE_COMMON_SHA256_H_
#define KG_BASE_COMMON_SHA256_H_

#include <memory>
#include <string>
#include <string_view>

#include "absl/types/span.h"

struct evp_md_ctx_st;  // OpenSSL's EVP_MD_CTX.

namespace kg_base {

// The digest as 64 lower case hexadecimal digits.
std::string Sha256Hex(std::string_view bytes);
// Throws InputError that names the file if it cannot be read.
std::string Sha256HexOfFile(const std::string& path);

// Hashes a sequence of values: equal sequences, and only they, have equal
// digests. Every value is added with its kind and its length, so ("ab", "c")
// and ("a", "bc") differ; all NaNs are equal, and -0 differs from 0.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;

  void Add(std::string_view text);
  void Add(const char* text) { Add(std::string_view(text)); }
  void Add(double value);
  void Add(absl::Span<const float> values);

  // The digest of all values so far; more may be added afterwards.
  std::string Hex() const;

 private:
  void AddBytes(const void* bytes, std::size_t size);
  void AddHead(char kind, std::size_t size);

  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

}  // namespace kg_base

#endif  // KG_BASE_COMMON_SHA256_H_
