// The ellipses of samples, where a field stretches their disks (docs/ellipses.md): which offsets
// (dx, dy) from its middle an ellipse holds, and its chords.
//
// An ellipse is a triangular map: u = p dx, v = q dx + s dy. It holds an offset if u^2 + v^2 is
// less than ELLIPSE_RADIUS^2, where u and v are in units of 2^-shift and rounded toward 0. The
// rounding only makes it larger. s is never 0, and q is a signed number.
#ifndef LACUNA_PORTABLE_ELLIPSE_H
#define LACUNA_PORTABLE_ELLIPSE_H
#include "elements.h"
#include "isqrt.h"

#define ELLIPSE_RADIUS 0x40000000u
#define ELLIPSE_RADIUS_TIMES_ROOT_2 0x5a82799bu  // and 1, because u and v are rounded

LACUNA_BEGIN

LACUNA_FN bool are_same(Ellipse a, Ellipse b) {
    return a.p == b.p && a.q == b.q && a.s == b.s && a.shift == b.shift;
}

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

// The part of [begin, end) that is nearer to 0 than `most`.
LACUNA_FN Interval cut_to(i64 begin, i64 end, i64 most) {
    Interval whole;
    whole.begin = begin;
    whole.end = end;
    Interval near;
    near.begin = 1 - most;
    near.end = most;
    return common_part(whole, near);
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

// Whether along * dx + up * dy stays on one side of a strip of 2 * most, for dx from left to right
// and dy from low to high. `up` is not negative.
LACUNA_FN bool is_beside(i64 along, i64 up, i64 most, i64 left, i64 right, i64 low, i64 high) {
    i64 a = along * left;
    i64 b = along * right;
    return (a < b ? a : b) + up * low >= most || (a < b ? b : a) + up * high <= -most;
}

// Whether the ellipse holds nothing of a rectangle, because it lies beside one of four strips that
// hold the ellipse: |u|, |v|, |u + v| / root(2) and |u - v| / root(2) are less than the radius.
// May return false although the ellipse misses the rectangle. Offsets are at most 2^30.5.
LACUNA_FN bool misses(Ellipse e, i64 left, i64 right, i64 low, i64 high) {
    i64 most = to_i64(ELLIPSE_RADIUS) << e.shift;
    i64 diagonal = to_i64(ELLIPSE_RADIUS_TIMES_ROOT_2) << e.shift;
    i64 p = to_i64(e.p);
    i64 q = sign_extended(e.q);
    i64 s = to_i64(e.s);
    return is_beside(p, 0, most, left, right, low, high) ||
           is_beside(q, s, most, left, right, low, high) ||
           is_beside(q + p, s, diagonal, left, right, low, high) ||
           is_beside(q - p, s, diagonal, left, right, low, high);
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

// How far image 0, 1 or 2 of an axis with a period lies from the axis.
LACUNA_FN i64 shift_of_image(u32 image, u32 period) {
    return (image == 1u ? to_i64(period) : 0) - (image == 2u ? to_i64(period) : 0);
}

// A height of window 0, 1 or 2 (see window_begin in chord.h), cut to the domain. So an interval of
// heights becomes three windows.
LACUNA_FN u32 height_in_window(u32 window, i64 at, u32 height) {
    i64 there = at + shift_of_image(window, height);
    return there < 0 ? 0u : there > to_i64(height) ? height : to_u32(there);
}

LACUNA_END

#endif
