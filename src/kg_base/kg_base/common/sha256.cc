#include "kg_base/common/sha256.h"

#include <openssl/evp.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

using Context = std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)>;

void Check(int result) {
  if (result != 1) throw std::runtime_error("SHA-256 is not available");
}

Context NewContext() {
  Context context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  if (!context) throw std::bad_alloc();
  Check(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
  return context;
}

std::string Finish(EVP_MD_CTX* context) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  Check(EVP_DigestFinal_ex(context, digest, &size));
  constexpr char kHex[] = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) {
    hex.push_back(kHex[digest[i] >> 4]);
    hex.push_back(kHex[digest[i] & 15]);
  }
  return hex;
}

// Little-endian bytes, so that digests agree between machines.
void StoreLittleEndian(std::uint64_t bits, int size, unsigned char* bytes) {
  for (int i = 0; i < size; ++i) bytes[i] = bits >> (8 * i) & 0xFF;
}

}  // namespace

std::string Sha256Hex(std::string_view bytes) {
  const Context context = NewContext();
  Check(EVP_DigestUpdate(context.get(), bytes.data(), bytes.size()));
  return Finish(context.get());
}

std::string Sha256HexOfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened for reading");
  const Context context = NewContext();
  char block[1 << 16];
  while (file.read(block, sizeof(block)), file.gcount() > 0) {
    Check(EVP_DigestUpdate(context.get(), block, file.gcount()));
  }
  if (file.bad() || !file.eof()) throw InputError(path + ": cannot be read");
  return Finish(context.get());
}

Hasher::Hasher() : context_(NewContext()) {}
Hasher::~Hasher() = default;
Hasher::Hasher(Hasher&&) noexcept = default;
Hasher& Hasher::operator=(Hasher&&) noexcept = default;

void Hasher::Add(std::string_view text) {
  AddHead('s', text.size());
  AddBytes(text.data(), text.size());
}

void Hasher::Add(double value) {
  if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  unsigned char bytes[8];
  StoreLittleEndian(bits, 8, bytes);
  AddHead('d', 1);
  AddBytes(bytes, sizeof(bytes));
}

void Hasher::Add(absl::Span<const float> values) {
  AddHead('f', values.size());
  constexpr std::size_t kBlock = 1024;
  unsigned char bytes[kBlock * 4];
  for (std::size_t at = 0; at < values.size(); at += kBlock) {
    const absl::Span<const float> block = values.subspan(at, kBlock);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const float value = std::isnan(block[i])
                              ? std::numeric_limits<float>::quiet_NaN()
                              : block[i];
      std::uint32_t bits;
      std::memcpy(&bits, &value, sizeof(bits));
      StoreLittleEndian(bits, 4, bytes + 4 * i);
    }
    AddBytes(bytes, block.size() * 4);
  }
}

std::string Hasher::Hex() const {
  const Context copy = NewContext();
  Check(EVP_MD_CTX_copy_ex(copy.get(), context_.get()));
  return Finish(copy.get());
}

void Hasher::AddBytes(const void* bytes, std::size_t size) {
  Check(EVP_DigestUpdate(context_.get(), bytes, size));
}

void Hasher::AddHead(char kind, std::size_t size) {
  unsigned char head[9];
  head[0] = static_cast<unsigned char>(kind);
  StoreLittleEndian(size, 8, head + 1);
  AddBytes(head, sizeof(head));
}

}  // namespace kg_base
