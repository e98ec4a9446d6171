// The body of assign: finds which of a unit's rivals wins each lattice point of a leaf, and sums
// what each rival gets.
#include "bodies/relax/late.h"
#include "bodies/relax/leaf.h"
#include "bodies/relax/place.h"
#include "bodies/relax/shares.h"
#include "bodies/relax/unit_leaves.h"

// A leaf's rows as separate variables: lavapipe keeps an array in registers only if all its indices
// are constants, and it unrolls no loop over more than one row.
#define FROM_ROW_0(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#define FROM_ROW_7(DO) DO(7) DO(6) DO(5) DO(4) DO(3) DO(2) DO(1) DO(0)

// A rival with the least value in the leaf's middle; if there are several, any of them.
BODY u32 first_in_middle(MEMORY const Place place, const Area leaf) {
    const i32 right = to_i32(leaf.width / 2u);
    const i32 up = to_i32(leaf.height / 2u);
    i32 least = 0x7fffffff;
    u32 first = 0u;
    for (u32 i = 0u; i < place.count; ++i) {
        const Near near = near_at(ON place, i);
        const i32 value = near.at + right * near.along_x + up * near.along_y;
        first = value < least ? i : first;
        least = value < least ? value : least;
    }
    return first;
}

// Keeps the rivals that `first` does not beat everywhere in the leaf; two rivals differ most in a
// corner. Returns the number of rivals that are kept.
BODY u32 keep_winners(MEMORY const Place place, const Area leaf, const u32 first, const u32 slot) {
    const i32 width = to_i32(leaf.width) - 1;
    const i32 height = to_i32(leaf.height) - 1;
    const Near other = near_at(ON place, first);
    u32 kept = 0u;
    for (u32 i = 0u; i < place.count; ++i) {
        const Near near = near_at(ON place, i);
        const i32 right = (near.along_x - other.along_x) * width;
        const i32 up = (near.along_y - other.along_y) * height;
        if (near.at - other.at + min(right, 0) + min(up, 0) > 0) continue;
        if (kept < WINNER_ROOM) AT(winners, slot + kept) = i;
        ++kept;
    }
    return kept;
}

// Each lattice point's mass as it is stored. Outside the lattice it is 0.
#define FETCH_MASSES(v)                                                                         \
    {                                                                                           \
        u32 pixel = (leaf.bottom + v) / a.lattice.cut_y * a.lattice.pixel_columns + left_pixel; \
        u32 rest = left_rest;                                                                   \
        for (u32 u = 0u; u < LEAF_SIDE; ++u) {                                                  \
            mass##v[u] = 0u;                                                                    \
            if (u < leaf.width && v < leaf.height) mass##v[u] = AT(masses, pixel);              \
            ++rest;                                                                             \
            pixel += rest == a.lattice.cut_x ? 1u : 0u;                                         \
            rest = rest == a.lattice.cut_x ? 0u : rest;                                         \
        }                                                                                       \
    }
// Most leaves have the exponent 0, with which masses are stored as they are.
#define FIT_MASSES(v) \
    for (u32 u = 0u; u < LEAF_SIDE; ++u) mass##v[u] = mass_in_leaf(mass##v[u], exponent);

// Is added to a mass that is not 0, so that one sum counts both.
#define ONE_POINT 0x4000000u
#define COUNT_POINTS(v) \
    for (u32 u = 0u; u < LEAF_SIDE; ++u) mass##v[u] += mass##v[u] != 0u ? ONE_POINT : 0u;

// For each lattice point the least value up to now, and the order of the rival that has it.
#define BEGIN_ROW(v)                       \
    i32 least##v[LEAF_SIDE];               \
    u32 owner##v[LEAF_SIDE];               \
    u32 mass##v[LEAF_SIDE];                \
    for (u32 u = 0u; u < LEAF_SIDE; ++u) { \
        least##v[u] = 0x7fffffff;          \
        owner##v[u] = 0xffffffffu;         \
    }
#define COMPARE(v)                                                                     \
    for (u32 u = 0u; u < LEAF_SIDE; ++u) {                                             \
        const i32 value = near.at + v * near.along_y + to_i32(u) * near.along_x;       \
        const bool is_less =                                                           \
            value < least##v[u] || (value == least##v[u] && near.order < owner##v[u]); \
        least##v[u] = is_less ? value : least##v[u];                                   \
        owner##v[u] = is_less ? near.order : owner##v[u];                              \
    }

// Rows are added from the top. After each row but the last all sums are added again, so that the
// masses of row v count v times. No sum of a column's masses reaches ONE_POINT: 28 * 2^21 is less.
#define SUM_UP(v)                                            \
    for (u32 u = 0u; u < LEAF_SIDE; ++u) {                   \
        above[u] += column[u];                               \
        column[u] += owner##v[u] == order ? mass##v[u] : 0u; \
    }

// Sums over lattice points won: their number, their mass, and their mass times u and times v.
struct Won {
    u32 points;
    u32 mass;
    u32 moment_u;
    u32 moment_v;
};
LACUNA_TYPEDEF(Won)

BODY Won nothing_won() {
    Won nothing;
    nothing.points = 0u;
    nothing.mass = 0u;
    nothing.moment_u = 0u;
    nothing.moment_v = 0u;
    return nothing;
}

BODY Won with_column(const Won sum, const u32 u, const u32 column, const u32 above) {
    const u32 mass = column % ONE_POINT;
    Won more = sum;
    more.points += column / ONE_POINT;
    more.mass += mass;
    more.moment_u += mass * u;
    more.moment_v += above % ONE_POINT;
    return more;
}

// `exponent` of the masses won.
BODY void give(MEMORY const LeafArguments a, const Area leaf, const Won won, const u32 exponent,
               const u32 id) {
    const u32 image = id % 16u;
    const Site site = LOAD(Site, sites, id / 16u);
    const u64 mass = won.mass;
    const u64 moment_x = won.moment_u + mass * leaf_offset(leaf.left, site.x, a.lattice.step_x,
                                                           a.lattice.columns, image % 3u);
    const u64 moment_y = won.moment_v + mass * leaf_offset(leaf.bottom, site.y, a.lattice.step_y,
                                                           a.lattice.rows, image / 3u);
    add_to_share(ON id / 16u, won.points, mass << exponent, moment_x << exponent,
                 moment_y << exponent);
}

BODY void share_out(MEMORY const LeafArguments a, const Area leaf, const Place place,
                    const u32 slot, const u32 kept) {
    const u32 left_pixel = leaf.left / a.lattice.cut_x;
    const u32 left_rest = leaf.left % a.lattice.cut_x;
    const u32 exponent = AT(exponents, number_of_leaf(a, leaf));
    FROM_ROW_0(BEGIN_ROW)
    FROM_ROW_0(FETCH_MASSES)
    if (exponent != 0u) {
        FROM_ROW_0(FIT_MASSES)
    }
    FROM_ROW_0(COUNT_POINTS)
    for (u32 k = 0u; k < kept; ++k) {
        const Near near = near_at(ON place, AT(winners, slot + k));
        FROM_ROW_0(COMPARE)
    }
    for (u32 k = 0u; k < kept; ++k) {
        const u32 rival = place.slot + AT(winners, slot + k);
        const u32 order = LOAD(ShortLag, rivals, rival).order;
        u32 column[LEAF_SIDE];
        u32 above[LEAF_SIDE];
        for (u32 u = 0u; u < LEAF_SIDE; ++u) {
            column[u] = 0u;
            above[u] = 0u;
        }
        FROM_ROW_7(SUM_UP)
        Won won = nothing_won();
        for (u32 u = 0u; u < LEAF_SIDE; ++u) won = with_column(won, u, column[u], above[u]);
        if (won.points != 0u) give(ON a, leaf, won, exponent, AT(rival_ids, rival));
    }
}

BODY void assign_leaf(MEMORY const LeafArguments a, const u32 index, const u32 i) {
    if ((leaves_of_unit(ON a, index) >> i & 1u) == 0u) return;
    const Area unit = unit_at(ON a, index);
    const Area leaf = leaf_of(a, unit, i);
    const Place place = place_of(ON unit, leaf, index);
    if (place.count == CROWDED) return;
    const u32 first = first_in_middle(ON place, leaf);
    AT(hints, number_of_leaf(a, leaf)) = AT(rival_ids, place.slot + first) / 16u;
    const u32 slot = (index * a.side * a.side + i) * WINNER_ROOM;
    const u32 kept = keep_winners(ON place, leaf, first, slot);
    if (kept > WINNER_ROOM) {
        leave_for_later(ON number_of_leaf(a, leaf));
        return;
    }
    share_out(ON a, leaf, place, slot, kept);
}

BODY void serve_assign(MEMORY const LeafArguments a, const u32 item) {
    const u32 leaves = a.side * a.side;
    const u32 end = min((item + 1u) * a.chunk, a.count * leaves);
    for (u32 i = item * a.chunk; i < end; ++i) assign_leaf(ON a, i / leaves, i % leaves);
    CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);
}
