/* The interface for C, as a program in C uses it: makes, moves and proves sets, and reads errors.
 *
 *     c_program PICTURE */
#include <lacuna.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                          \
    do {                                                                           \
        if (!(condition)) {                                                        \
            printf("%s:%d: not so: %s (\"%s\")\n", __FILE__, __LINE__, #condition, \
                   lacuna_error());                                                \
            ++failures;                                                            \
        }                                                                          \
    } while (0)

static void expect_error(const lacuna_set* set, const char* part) {
    EXPECT(set == NULL);
    if (strstr(lacuna_error(), part) == NULL) {
        printf("expected \"%s\" in \"%s\"\n", part, lacuna_error());
        ++failures;
    }
}

static void sets_are_made_and_proven(void) {
    lacuna_set* set = lacuna_sample(" --radius 0.05\t--torus --seed=7 ", NULL);
    EXPECT(set != NULL && strcmp(lacuna_error(), "") == 0);
    EXPECT(lacuna_count(set) > 250 && lacuna_count(set) < 310);
    const lacuna_facts facts = lacuna_describe(set);
    EXPECT(facts.width == 1 && facts.height == 1 && facts.radius == 0.05 && facts.maximal == 1);
    EXPECT(lacuna_diameters(set) == NULL && lacuna_layers(set) == NULL);
    EXPECT(lacuna_verify("--radius 0.05 --torus", NULL, lacuna_points(set), lacuna_count(set)) ==
           1);
    EXPECT(lacuna_verify("--radius 0.06 --torus", NULL, lacuna_points(set), lacuna_count(set)) ==
           0);
    EXPECT(strstr(lacuna_error(), "apart, less than 0.06") != NULL);
    EXPECT(lacuna_verify("--radius 0.03 --torus", NULL, lacuna_points(set), lacuna_count(set)) ==
           0);
    EXPECT(strstr(lacuna_error(), "there is room for a point at (") != NULL);
    EXPECT(lacuna_verify("--radius 0.03 --torus --distances-only", NULL, lacuna_points(set),
                         lacuna_count(set)) == 1);
    const double middle[2] = {0.5, 0.5};
    EXPECT(lacuna_verify("--radius 0.1 --tolerance 1", NULL, middle, 1) == 0);
    EXPECT(strstr(lacuna_error(), "not proven maximal") != NULL);
    EXPECT(lacuna_verify("--torus", NULL, lacuna_points(set), lacuna_count(set)) == -1);
    EXPECT(strstr(lacuna_error(), "radius") != NULL);

    /* The first three points are kept, and new ones fill the space around them. */
    lacuna_given given;
    memset(&given, 0, sizeof(given));
    double kept[6];
    memcpy(kept, lacuna_points(set), sizeof(kept));
    given.kept = kept;
    given.kept_count = 3;
    lacuna_set* more = lacuna_sample("--radius 0.05 --torus --seed 8", &given);
    EXPECT(more != NULL && memcmp(lacuna_points(more), kept, sizeof(kept)) == 0);
    EXPECT(lacuna_verify("--radius 0.05 --torus", &given, lacuna_points(more),
                         lacuna_count(more)) == 1);
    EXPECT(lacuna_verify("--radius 0.05 --torus", &given, lacuna_points(more) + 2,
                         lacuna_count(more) - 1) == 0);
    lacuna_free(more);
    lacuna_free(set);
}

static void fields_say_where_points_are_wanted(void) {
    double importance[8] = {0, 0, 1, 1, 0, 0, 1, 1};
    lacuna_given given;
    memset(&given, 0, sizeof(given));
    given.importance = importance;
    given.columns = 4;
    given.rows = 2;
    lacuna_set* set = lacuna_sample("--scale 0.02", &given);
    EXPECT(set != NULL && lacuna_describe(set).width == 1 && lacuna_describe(set).height == 0.5);
    size_t i;
    for (i = 0; i < lacuna_count(set); ++i) EXPECT(lacuna_points(set)[2 * i] >= 0.5);
    EXPECT(lacuna_verify("--scale 0.02", &given, lacuna_points(set), lacuna_count(set)) == 1);

    lacuna_set* moved =
        lacuna_relax("--iterations 5", &given, lacuna_points(set), lacuna_count(set));
    EXPECT(lacuna_count(moved) == lacuna_count(set) && lacuna_describe(moved).maximal == 0);
    EXPECT(memcmp(lacuna_points(moved), lacuna_points(set), 16 * lacuna_count(set)) != 0);
    lacuna_free(moved);
    lacuna_free(set);
    given.rows = 0;
    expect_error(lacuna_sample("--scale 0.02", &given), "4x0");
}

static void masks_say_where_points_may_lie(void) {
    const unsigned char allowed[8] = {1, 0, 0, 0, 1, 0, 0, 0};
    lacuna_given given;
    memset(&given, 0, sizeof(given));
    given.allowed = allowed;
    given.mask_columns = 4;
    given.mask_rows = 2;
    lacuna_set* set = lacuna_sample("--radius 3 --domain 100,-50+80x40", &given);
    const lacuna_facts facts = lacuna_describe(set);
    EXPECT(facts.x == 100 && facts.y == -50 && facts.width == 80 && lacuna_count(set) > 40);
    size_t i;
    for (i = 0; i < lacuna_count(set); ++i)
        EXPECT(lacuna_points(set)[2 * i] >= 100 && lacuna_points(set)[2 * i] <= 120);
    EXPECT(lacuna_verify("--radius 3 --domain 100,-50+80x40", &given, lacuna_points(set),
                         lacuna_count(set)) == 1);
    EXPECT(lacuna_verify("--radius 3 --domain 100,-50+80x40", NULL, lacuna_points(set),
                         lacuna_count(set)) == 0);
    expect_error(lacuna_relax("", &given, lacuna_points(set), lacuna_count(set)), "mask");
    lacuna_free(set);
    set = lacuna_sample("--radius 0.05", &given);
    EXPECT(lacuna_describe(set).height == 0.5);
    lacuna_free(set);
    given.mask_rows = 0;
    expect_error(lacuna_sample("--radius 0.05", &given), "mask 4x0");
    given.allowed = NULL;
    expect_error(lacuna_sample("--radius 0.05", &given), "mask NULL: must be 4x0 numbers");
}

static void pictures_become_dots(const char* path) {
    static char content[1 << 22];
    FILE* file = fopen(path, "rb");
    const size_t bytes = file == NULL ? 0 : fread(content, 1, sizeof(content), file);
    if (file != NULL) fclose(file);
    EXPECT(bytes > 1000);
    lacuna_set* dots = lacuna_stipple("--count 500 --inks cmyk --relax 3", content, bytes);
    EXPECT(lacuna_count(dots) == 500 && lacuna_diameters(dots) != NULL);
    EXPECT(lacuna_layers(dots) != NULL && lacuna_layers(dots)[0] == 0 &&
           lacuna_layers(dots)[499] == 3);
    lacuna_free(dots);
    dots = lacuna_stipple("--count 500", content, bytes);
    EXPECT(lacuna_count(dots) == 500 && lacuna_layers(dots) == NULL);
    lacuna_free(dots);
    expect_error(lacuna_stipple("", "no picture", 10), "the picture");
    expect_error(lacuna_stipple("--along 3", content, bytes), "along 3: makes ellipses");
}

static void what_is_not_understood_is_refused(void) {
    expect_error(lacuna_sample("--radios 0.1", NULL),
                 "options --radios: is no option of lacuna sample");
    expect_error(lacuna_sample("0.1", NULL), "options 0.1: is no option");
    expect_error(lacuna_sample("--radius", NULL), "radius");
    expect_error(lacuna_sample("--radius 0.1 --radius 0.2", NULL), "is given twice");
    expect_error(lacuna_sample("--radius 0.1 --inside lakes.svg", NULL),
                 "options --inside: is for the command alone");
    expect_error(lacuna_sample(NULL, NULL), "radius");
    expect_error(lacuna_relax("", NULL, NULL, 3), "points NULL: must be 3 points");
    expect_error(lacuna_stipple("", NULL, 3), "picture NULL");
    const double one[2] = {0.5, 0.5};
    lacuna_given given;
    memset(&given, 0, sizeof(given));
    given.kept = one;
    given.kept_count = 1;
    expect_error(lacuna_relax("", &given, one, 1), "keep 1 points: are not for relax");
    expect_error(lacuna_sample("--radius 0.1 --relax 3", &given), "keep");
    EXPECT(lacuna_count(NULL) == 0 && lacuna_points(NULL) == NULL && lacuna_layers(NULL) == NULL);
    EXPECT(lacuna_describe(NULL).width == 0 && lacuna_diameters(NULL) == NULL);
    lacuna_free(NULL);
}

static double least_distance_in_space(const lacuna_set* set) {
    const double* points = lacuna_points(set);
    double least = 1e9;
    size_t i, k;
    for (i = 0; i < lacuna_count(set); ++i)
        for (k = 0; k < i; ++k)
            least = fmin(least, hypot(hypot(points[3 * i] - points[3 * k],
                                            points[3 * i + 1] - points[3 * k + 1]),
                                      points[3 * i + 2] - points[3 * k + 2]));
    return least;
}

static void sets_lie_on_meshes_and_in_volumes(void) {
    /* A wedge: two squares. */
    const double vertices[18] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 1, 2, 1, 1};
    const unsigned triangles[12] = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    const unsigned char allowed[4] = {1, 1, 0, 0};
    const double kept[3] = {0.5, 0.5, 0};
    lacuna_mesh mesh;
    memset(&mesh, 0, sizeof(mesh));
    mesh.vertices = vertices;
    mesh.vertex_count = 6;
    mesh.triangles = triangles;
    mesh.triangle_count = 4;
    lacuna_set* set = lacuna_sample_surface("--radius 0.1 --seed 3", &mesh, kept, 1);
    EXPECT(lacuna_count(set) > 150 && memcmp(lacuna_points(set), kept, sizeof(kept)) == 0);
    EXPECT(lacuna_triangles(set) != NULL && lacuna_triangles(set)[0] < 4);
    EXPECT(lacuna_describe(set).maximal == 1 && lacuna_describe(set).width == 0);
    EXPECT(least_distance_in_space(set) >= 0.1 && least_distance_in_space(set) < 0.11);
    lacuna_free(set);
    mesh.allowed = allowed;
    set = lacuna_sample_surface("--count 50", &mesh, NULL, 0);
    EXPECT(lacuna_count(set) == 50 && lacuna_triangles(set)[49] < 2);
    lacuna_free(set);
    expect_error(lacuna_sample_surface("--radius 0.1", NULL, NULL, 0), "mesh NULL: give one");
    mesh.triangle_count = 0;
    expect_error(lacuna_sample_surface("--radius 0.1", &mesh, NULL, 0), "without triangles");

    set = lacuna_sample_volume("--radius 0.2 --domain 1x2x0.5 --torus", NULL, 0);
    EXPECT(lacuna_describe(set).depth == 0.5 && lacuna_triangles(set) == NULL);
    EXPECT(lacuna_count(set) > 80 && least_distance_in_space(set) >= 0.2);
    lacuna_free(set);
    expect_error(lacuna_sample_volume("--radius 0.2 --domain 1x2", NULL, 0),
                 "1x2 with points in space");
    expect_error(lacuna_sample_volume("--radius 0.2 --relax 3", NULL, 0), "command alone");
}

static int stop_halfway(double done, void* user) {
    double* const most = user;
    if (done > *most) *most = done;
    return done < 0.5;
}

static void calls_can_be_watched_and_stopped(void) {
    double most = -1;
    lacuna_watch(stop_halfway, &most);
    expect_error(lacuna_sample("--radius 0.002", NULL), "cancelled");
    EXPECT(most >= 0.5 && most <= 1);
    lacuna_watch(NULL, NULL);
    lacuna_set* set = lacuna_sample("--radius 0.1", NULL);
    EXPECT(set != NULL);
    lacuna_free(set);
}

int main(int count, char** arguments) {
    if (count != 2) return 2;
    EXPECT(strcmp(lacuna_version(), "0.1.0") == 0);
    sets_are_made_and_proven();
    fields_say_where_points_are_wanted();
    masks_say_where_points_may_lie();
    pictures_become_dots(arguments[1]);
    what_is_not_understood_is_refused();
    sets_lie_on_meshes_and_in_volumes();
    calls_can_be_watched_and_stopped();
    if (failures == 0) printf("all is as lacuna.h says\n");
    return failures == 0 ? 0 : 1;
}
