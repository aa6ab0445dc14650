#include "kg_core/raster/digest.h"

#include <openssl/evp.h>

#include <stdexcept>

namespace kg_core {

Digest::Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
  if (EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available");
  }
}

void Digest::AddBytes(const void* bytes, std::size_t count) {
  if (count > 0) EVP_DigestUpdate(context_.get(), bytes, count);
}

std::string Digest::Hex() {
  unsigned char sum[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  EVP_DigestFinal_ex(context_.get(), sum, &size);
  static const char kDigits[] = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    hex += kDigits[sum[i] >> 4];
    hex += kDigits[sum[i] & 15];
  }
  return hex;
}

}  // namespace kg_core
