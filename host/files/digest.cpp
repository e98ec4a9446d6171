// The SHA-256 of a point set's coordinates: it does not depend on the file's format.
#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <string>

#include "base/polling.h"
#include "files/little_endian.h"
#include "files/point_files.h"

namespace lacuna::files {
namespace {

// How many numbers OpenSSL is given at once, because one call costs more than hashing one number.
constexpr std::size_t kNumbersPerUpdate = 8192;

void check(int openssl_result, const char* call) {
    if (openssl_result != 1) throw Error(std::string("SHA-256: ") + call + " of OpenSSL failed");
}

}  // namespace

struct Sha256OfPoints::State {
    struct Deleter {
        void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
    };
    std::unique_ptr<EVP_MD_CTX, Deleter> context{EVP_MD_CTX_new()};
    std::string bytes;
};

Sha256OfPoints::Sha256OfPoints() : state_(std::make_unique<State>()) {
    EVP_MD_CTX* const context = state_->context.get();
    // Every OpenSSL has SHA-256: only memory can be missing.
    if (context == nullptr || EVP_DigestInit_ex(context, EVP_sha256(), nullptr) != 1)
        throw std::bad_alloc();
}

Sha256OfPoints::~Sha256OfPoints() = default;

void Sha256OfPoints::add(std::span<const Point> points) {
    static_assert(sizeof(Point) == 2 * sizeof(double));
    if (!points.empty()) add_numbers({&points.front().x, 2 * points.size()});
}

void Sha256OfPoints::add_numbers(std::span<const double> numbers) {
    auto& [context, bytes] = *state_;
    while (!numbers.empty()) {
        const std::size_t count = std::min(kNumbersPerUpdate, numbers.size());
        ask_after(2 * count);
        bytes.clear();
        for (const double number : numbers.first(count)) append_little_endian(bytes, number);
        check(EVP_DigestUpdate(context.get(), bytes.data(), bytes.size()), "EVP_DigestUpdate");
        numbers = numbers.subspan(count);
    }
}

void Sha256OfPoints::add_bytes(std::string_view bytes) {
    constexpr std::size_t kBytesPerUpdate = std::size_t{1} << 16U;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(kBytesPerUpdate, bytes.size()))) {
        const std::string_view part = bytes.substr(0, kBytesPerUpdate);
        ask_after(part.size() / sizeof(double));
        check(EVP_DigestUpdate(state_->context.get(), part.data(), part.size()),
              "EVP_DigestUpdate");
    }
}

std::string Sha256OfPoints::hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    check(EVP_DigestFinal_ex(state_->context.get(), digest.data(), &length), "EVP_DigestFinal_ex");
    std::string hex;
    for (const unsigned char byte : std::span(digest).first(length))
        hex += fmt::format("{:02x}", byte);
    return hex;
}

std::string sha256_of_bytes(std::string_view bytes) {
    Sha256OfPoints digest;
    digest.add_bytes(bytes);
    return digest.hex();
}

std::string sha256_of(std::span<const Point> points) {
    Sha256OfPoints digest;
    digest.add(points);
    return digest.hex();
}

std::string sha256_in_space(std::span<const Point3> points) {
    static_assert(sizeof(Point3) == 3 * sizeof(double));
    Sha256OfPoints digest;
    if (!points.empty()) digest.add_numbers({&points.front().x, 3 * points.size()});
    return digest.hex();
}

}  // namespace lacuna::files
