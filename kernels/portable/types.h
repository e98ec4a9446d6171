// Defines the names that portable headers use, for C++, OpenCL C and GLSL.
//
// A portable header has functions on whole numbers: values in, values out. The only float is the
// estimate of a square root below, which isqrt.h corrects exactly.
#ifndef LACUNA_PORTABLE_TYPES_H
#define LACUNA_PORTABLE_TYPES_H

#if defined(__cplusplus)
#include <bit>
#include <cmath>
#include <cstdint>
#define LACUNA_BEGIN namespace lacuna::portable {
#define LACUNA_END }
#define LACUNA_FN inline
#define LACUNA_TYPEDEF(name)
LACUNA_BEGIN
using u32 = std::uint32_t;
using u64 = std::uint64_t;
using i32 = std::int32_t;
using i64 = std::int64_t;
template <typename T>
inline u32 to_u32(T a) {
    return static_cast<u32>(a);
}
inline i32 to_i32(u32 a) {
    return static_cast<i32>(a);
}
template <typename T>
inline i64 to_i64(T a) {
    return static_cast<i64>(a);
}
inline u64 to_u64(i64 a) {
    return static_cast<u64>(a);
}
inline i64 sign_extended(u32 a) {
    return static_cast<std::int32_t>(a);
}
inline u32 count_bits(u32 a) {
#if defined(__x86_64__) && !defined(__POPCNT__)  // std::popcount would be a call
    a -= a >> 1 & 0x55555555U;
    a = (a & 0x33333333U) + (a >> 2 & 0x33333333U);
    return ((a + (a >> 4)) & 0x0f0f0f0fU) * 0x01010101U >> 24;
#else
    return static_cast<u32>(std::popcount(a));
#endif
}
inline u32 leading_zeros(u32 a) {
    return static_cast<u32>(std::countl_zero(a));
}
inline u64 sqrt_estimate(u64 n) {  // through signed numbers, which convert in one instruction
    const double wide = static_cast<double>(static_cast<std::int64_t>(n));
    return static_cast<u64>(static_cast<std::int64_t>(std::sqrt(wide)));
}
LACUNA_END

#elif defined(__OPENCL_C_VERSION__)
#define LACUNA_BEGIN
#define LACUNA_END
#define LACUNA_FN static inline
#define LACUNA_TYPEDEF(name) typedef struct name name;
typedef uint u32;
typedef ulong u64;
typedef int i32;
typedef long i64;
#define to_i32(a) ((i32)(a))
#define to_i64(a) ((i64)(a))
#define to_u64(a) ((u64)(a))
#define sign_extended(a) ((i64)(int)(a))
#define to_u32(a) ((u32)(a))
#define count_bits(a) popcount(a)
#define leading_zeros(a) clz(a)
#ifdef cl_khr_fp64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#define sqrt_estimate(n) ((u64)sqrt((double)(n)))
#else
#define LACUNA_FLOAT_ROOT
#define float_of(n) ((float)(n))
#define floor_of(x) ((u32)(x))
#endif

#else  // GLSL, with GL_EXT_shader_explicit_arithmetic_types_int64
#define LACUNA_BEGIN
#define LACUNA_END
#define LACUNA_FN
#define LACUNA_TYPEDEF(name)
#define u32 uint
#define u64 uint64_t
#define i32 int
#define i64 int64_t
#define to_i32(a) int(a)
#define to_i64(a) int64_t(a)
#define to_u64(a) uint64_t(a)
#define sign_extended(a) int64_t(int(a))
#define to_u32(a) uint(a)
#define count_bits(a) uint(bitCount(a))
#define leading_zeros(a) uint(31 - findMSB(a))
#define LACUNA_FLOAT_ROOT
// In two halves: this is many times faster on processors that convert 32 bits at a time.
#define float_of(n) (float(uint((n) >> 32)) * 4294967296.0f + float(uint(n)))
#define floor_of(x) uint(x)
#endif

#ifdef LACUNA_FLOAT_ROOT
// The first root has 24 correct bits; one Newton step on the exact residual gives the rest. 1 is
// added so that the division is safe.
LACUNA_FN u64 sqrt_estimate(u64 n) {
    float root = sqrt(float_of(n)) + 1.0f;
    u64 whole = floor_of(root);
    u64 square = whole * whole;
    bool is_low = square < n;
    u64 residual = is_low ? n - square : square - n;
    u64 step = floor_of(float_of(residual) / (2.0f * root));
    return is_low ? whole + step : whole - step;
}
#endif

#endif
