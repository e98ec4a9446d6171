/* Lacuna for C, and for all languages that call C: point sets by the options of the command.
 *
 *     #include <lacuna.h>
 *
 *     lacuna_set* set = lacuna_sample("--radius 0.01 --torus --seed 7", NULL);
 *     if (set == NULL) fprintf(stderr, "%s\n", lacuna_error());
 *     const double* xy = lacuna_points(set);
 *     for (size_t i = 0; i < lacuna_count(set); ++i) printf("%g %g\n", xy[2 * i], xy[2 * i + 1]);
 *     lacuna_free(set);
 *
 * Link the shared library lacuna, built with LACUNA_EXTRAS; or lacuna::extras and C++'s runtime.
 *
 * Options are one text, as on the command line of `lacuna sample` and the others, which give the
 * same points. What is not understood is refused, and nothing is made. So are options for which
 * there is nothing here: of files and polygons, ellipses and strokes, several seeds, how a picture
 * is read where importance is given, and what is drawn. Classes of points have --class NAME:R, once
 * for each, --priority, and --border NAME:D; --between is sum or union, not a file of distances.
 * --chunk I,J makes a chunk of a plane, in which outlines lie.
 *
 * Calls may be made on several threads at once. A set may be read by several threads, until it is
 * freed. */
#ifndef LACUNA_H
#define LACUNA_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define LACUNA_C_API __attribute__((visibility("default")))
#else
#define LACUNA_C_API
#endif

/* Points that a call has made. */
typedef struct lacuna_set lacuna_set;

/* What a call is given beside its options: NULL and 0 for what there is not. It is read during the
 * call alone. */
typedef struct lacuna_given {
    /* Where points are wanted, as of --field: rows * columns finite numbers of at least 0, 1 where
     * most are, row by row from the top. The domain has the field's shape, and a longer side of 1,
     * unless there is a --domain. */
    const double* importance;
    size_t columns;
    size_t rows;
    /* Points that are there already, as of --keep: x and y, alternately. Those outside of a box are
     * no points of the set, but points keep their distance from them. */
    const double* kept;
    size_t kept_count;
    /* Where points may lie, as of --mask: mask_columns * mask_rows bytes, 0 where none may, row by
     * row from the top. They are stretched over the domain, which has their shape, and a longer
     * side of 1, unless there is a --domain or a field. */
    const unsigned char* allowed;
    size_t mask_columns;
    size_t mask_rows;
    /* With --class, the class of each kept point: its number, from 0 in the order of --class. */
    const unsigned char* kept_classes;
    /* With --class, likewise of each point that lacuna_verify() is given, and for no other call. */
    const unsigned char* classes;
    /* Polygons, obstacles and what points are near, in place of a mask. Without --domain they
     * decide the domain: 1x1, or as far as they reach. Points may begin --edge E inside of an
     * outline, by default a sixteenth of the least radius. */
    const struct lacuna_outline* outlines;
    size_t outline_count;
} lacuna_given;

/* Rings that belong together, and what they are for points. */
typedef struct lacuna_outline {
    /* x and y of each point of all rings, ring after ring, each closed without its first point
     * again. An odd number of rings goes around what is inside: a ring in a ring is a hole. */
    const double* xy;
    const size_t* ring_sizes;
    size_t rings;
    /* "inside", "outside", "avoid" or "near". The last two keep points away from the rings, or near
     * to any of them, by `distance`; a ring of two points is a line, and of one a point. */
    const char* role;
    double distance;
    /* The class of --class that it is for; NULL: all. */
    const char* of_class;
} lacuna_outline;

/* The version, such as "0.1.0". */
LACUNA_C_API const char* lacuna_version(void);

/* One line that says why the last call of this thread failed or, after lacuna_verify() returned 0,
 * what the set lacks. "" after a call that did what was asked. Valid until the thread's next call
 * that makes or verifies a set. */
LACUNA_C_API const char* lacuna_error(void);

/* From now on each call of this thread that makes or verifies a set calls `go_on` now and then,
 * with the share of the work that is done, from 0 to 1, and with `user`. The call ends as failed if
 * it returns 0. lacuna_verify() does not know the share, and says 0. NULL: nothing is called.
 * `go_on` must not call lacuna_watch(), and must not make or verify a set. */
LACUNA_C_API void lacuna_watch(int (*go_on)(double done, void* user), void* user);

/* The points of `lacuna sample OPTIONS`. NULL if it failed, as of the next two. */
LACUNA_C_API lacuna_set* lacuna_sample(const char* options, const lacuna_given* given);

/* The dots of a picture, as of `lacuna stipple PICTURE OPTIONS`. The picture is the content of a
 * file: .png .jpg .tif .webp and others. Its longer side is 1, and y goes upwards. */
LACUNA_C_API lacuna_set* lacuna_stipple(const char* options, const void* picture, size_t bytes);

/* The points, moved until they are even, as by `lacuna relax`; in the order given. `points` has
 * `count` times x and y. Where points are wanted is given, and no points to keep. */
LACUNA_C_API lacuna_set* lacuna_relax(const char* options, const lacuna_given* given,
                                      const double* points, size_t count);

/* Proves from the coordinates alone that points keep their distance and leave no room for another
 * one, as `lacuna verify` does: "--radius R", or with importance "--scale R", or of
 * classes "--class NAME:R" for each; and --domain, --torus, --between, --border,
 * --inside-by-radius, --tolerance and --distances-only. Returns 1 if that is so, 0 if not or if the
 * tolerance is over 1 % of the radius, which proves nothing, and -1 if it failed. Kept points are
 * the first of the set. */
LACUNA_C_API int lacuna_verify(const char* options, const lacuna_given* given, const double* points,
                               size_t count);

/* A surface of triangles. Holes, triangles without area, edges of three triangles and triangles
 * that cross each other are as good as others. */
typedef struct lacuna_mesh {
    /* x, y and z of each vertex. */
    const double* vertices;
    size_t vertex_count;
    /* The numbers of the three vertices of each triangle, from 0. */
    const unsigned* triangles;
    size_t triangle_count;
    /* Whether points may lie on each triangle; NULL: on all. */
    const unsigned char* allowed;
} lacuna_mesh;

/* Points on the surface of a mesh, as of `lacuna sample --on MESH OPTIONS`. Distances are straight
 * through space. `kept` has x, y and z of points that are there already. NULL if it failed. */
LACUNA_C_API lacuna_set* lacuna_sample_surface(const char* options, const lacuna_mesh* mesh,
                                               const double* kept, size_t kept_count);

/* Points in a box or a torus of three sides: "--domain WxHxD", 1x1x1 if there is none, and --torus.
 * NULL if it failed. */
LACUNA_C_API lacuna_set* lacuna_sample_volume(const char* options, const double* kept,
                                              size_t kept_count);

/* The number of points. 0 for NULL, as all that follows is NULL for NULL. */
LACUNA_C_API size_t lacuna_count(const lacuna_set* set);

/* x and y of each point, alternately, in the order in which files have them; in space x, y and z.
 * These arrays are the set's: valid until it is freed. */
LACUNA_C_API const double* lacuna_points(const lacuna_set* set);

/* The diameter of each dot in the domain's unit; NULL for a set that is not of lacuna_stipple(). */
LACUNA_C_API const double* lacuna_diameters(const lacuna_set* set);

/* The layer of each dot: the number of its ink, from 0 in the order of --inks, or of its pen, or of
 * its ink times the number of pens plus its pen; NULL for one layer. Dots come layer by layer. With
 * --class, which gives an .svg a layer for each class, the class of each point: its number, from 0
 * in the order of --class. Points of all classes come mixed. */
LACUNA_C_API const unsigned char* lacuna_layers(const lacuna_set* set);

/* On a mesh the number of each point's triangle, from 0, except for those that were kept, which are
 * the first ones; NULL for other sets. */
LACUNA_C_API const unsigned* lacuna_triangles(const lacuna_set* set);

typedef struct lacuna_facts {
    /* Of the domain; 0 on a mesh. */
    double width;
    double height;
    /* The least distance that was kept or, of points that were moved, is found; 0: unknown. */
    double radius;
    /* 1 if no room is left for another point. */
    int maximal;
    /* The domain's lower left corner. */
    double x;
    double y;
    /* Of a volume; 0 for other sets. */
    double depth;
} lacuna_facts;

/* What is known of a set; all 0 for NULL. */
LACUNA_C_API lacuna_facts lacuna_describe(const lacuna_set* set);

/* Frees the set and its arrays. Does nothing for NULL. */
LACUNA_C_API void lacuna_free(lacuna_set* set);

#ifdef __cplusplus
}
#endif

#endif
