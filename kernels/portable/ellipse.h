// The ellipses of samples, where a field stretches their disks (docs/ellipses.md): which offsets
// (dx, dy) from its middle an ellipse holds, and its chords.
//
// An ellipse is a triangular map: u = p dx, v = q dx + s dy. It holds an offset if u^2 + v^2 is
// less than ELLIPSE_RADIUS^2, where u and v are in units of 2^-shift and rounded toward 0. The
// rounding only makes it larger. s is never 0.
#ifndef LACUNA_PORTABLE_ELLIPSE_H
#define LACUNA_PORTABLE_ELLIPSE_H
#include "isqrt.h"

#define ELLIPSE_RADIUS 0x40000000u

LACUNA_BEGIN

struct Ellipse {
    u32 p;
    u32 q;  // a signed number
    u32 s;
    u32 shift;
};
LACUNA_TYPEDEF(Ellipse)

// Offsets [begin, end); none if begin >= end.
struct Interval {
    i64 begin;
    i64 end;
};
LACUNA_TYPEDEF(Interval)

LACUNA_FN u64 magnitude(i64 a) {
    return to_u64(a < 0 ? -a : a);
}

LACUNA_FN bool holds(Ellipse e, i64 dx, i64 dy) {
    u64 u = magnitude(dx) * e.p >> e.shift;
    u64 v = magnitude(sign_extended(e.q) * dx + to_i64(e.s) * dy) >> e.shift;
    u64 radius = ELLIPSE_RADIUS;
    if (u >= radius || v >= radius) return false;
    return u * u + v * v < radius * radius;
}

LACUNA_FN i64 floor_of_quotient(i64 a, i64 divisor) {
    return a >= 0 ? a / divisor : -((divisor - 1 - a) / divisor);
}

LACUNA_FN Interval common_part(Interval a, Interval b) {
    Interval both;
    both.begin = a.begin > b.begin ? a.begin : b.begin;
    both.end = a.end < b.end ? a.end : b.end;
    return both;
}

// The dy for which holds(e, dx, dy). With `slack` 1 it is a little less: so little that the ellipse
// also holds everything between the chords with slack at two dx, in spite of the rounding.
LACUNA_FN Interval chord_at(Ellipse e, i64 dx, u32 slack) {
    Interval chord;
    chord.begin = 0;
    chord.end = 0;
    u64 u = (magnitude(dx) * e.p >> e.shift) + slack;
    u64 radius = ELLIPSE_RADIUS;
    if (u >= radius) return chord;
    // |v| is at most the root, so q dx + s dy lies between -most and most.
    i64 most = to_i64((isqrt(radius * radius - u * u - 1u) + 1u - slack) << e.shift);
    i64 aside = sign_extended(e.q) * dx;
    chord.begin = floor_of_quotient(-most - aside, to_i64(e.s)) + 1;
    chord.end = -floor_of_quotient(aside - most, to_i64(e.s));
    return chord;
}

// Whether the ellipse holds none of the offsets (dx, low) to (dx, high). Some that it does not hold
// are not told; this needs no square root.
LACUNA_FN bool misses(Ellipse e, i64 dx, i64 low, i64 high) {
    i64 most = to_i64(ELLIPSE_RADIUS) << e.shift;
    i64 aside = sign_extended(e.q) * dx;
    return to_i64(magnitude(dx)) * to_i64(e.p) >= most || aside + to_i64(e.s) * low >= most ||
           aside + to_i64(e.s) * high <= -most;
}

// Whether chord_at(e, dx, 1) has dy; this needs no square root.
LACUNA_FN bool holds_with_slack(Ellipse e, i64 dx, i64 dy) {
    u64 u = (magnitude(dx) * e.p >> e.shift) + 1u;
    u64 v = (magnitude(sign_extended(e.q) * dx + to_i64(e.s) * dy) >> e.shift) + 1u;
    u64 radius = ELLIPSE_RADIUS;
    if (u >= radius || v >= radius) return false;
    return u * u + v * v < radius * radius;
}

// The dy that the ellipse holds at all dx from middle - reach to middle + reach. An ellipse is
// convex: what it holds at both ends it holds between them.
LACUNA_FN Interval chord_around(Ellipse e, i64 middle, i64 reach) {
    if (reach == 0) return chord_at(e, middle, 0u);
    return common_part(chord_at(e, middle - reach, 1u), chord_at(e, middle + reach, 1u));
}

// A circle that holds no offset of this length or more, in spite of the rounding. The radius lies
// between 2 and 2^31.
LACUNA_FN Ellipse circle_of(u32 radius) {
    Ellipse circle;
    circle.shift = 32u - leading_zeros(radius);
    u64 scaled = ELLIPSE_RADIUS;
    circle.p = to_u32((scaled << circle.shift) / radius) + 4u;
    circle.q = 0u;
    circle.s = circle.p;
    return circle;
}

// The way from a to b on one axis, the shorter one if the axis wraps after `period` units; 0: it
// does not wrap.
LACUNA_FN i64 way_to(i64 a, i64 b, u32 period) {
    i64 way = b - a;
    i64 around = to_i64(period);
    if (2 * way > around && period != 0u) return way - around;
    return 2 * way < -around && period != 0u ? way + around : way;
}

// A height of window 0, 1 or 2 (see window_begin in chord.h), cut to the domain. So an interval of
// heights becomes three windows.
LACUNA_FN u32 height_in_window(u32 window, i64 at, u32 height) {
    i64 there = at + (window == 1u ? to_i64(height) : 0) - (window == 2u ? to_i64(height) : 0);
    return there < 0 ? 0u : there > to_i64(height) ? height : to_u32(there);
}

LACUNA_END

#endif
