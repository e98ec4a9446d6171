/* Trees and bushes in a park with a pond, off the road and near the fence, from arrays in memory. */
#include <lacuna.h>
#include <stdio.h>

int main(void) {
    const double park[] = {0, 0, 90, 5, 100, 70, 10, 80, 40, 30, 60, 30, 50, 45}; /* then the pond */
    const double road[] = {0, 60, 100, 20}, fence[] = {10, 10, 85, 12};
    const size_t park_sizes[] = {4, 3}, line[] = {2};
    const lacuna_outline outlines[] = {{park, park_sizes, 2, "inside", 0, NULL},
                                       {road, line, 1, "avoid", 3, NULL},
                                       {fence, line, 1, "near", 25, NULL}};
    lacuna_given given = {0};
    given.outlines = outlines;
    given.outline_count = 3;
    lacuna_set* set = lacuna_sample("--class trees:2.5 --class bushes:0.8", &given);
    if (set == NULL) return fprintf(stderr, "%s\n", lacuna_error()), 1;
    const double* xy = lacuna_points(set);
    const unsigned char* kind = lacuna_layers(set);
    for (size_t i = 0; i < lacuna_count(set); ++i)
        printf("%.17g %.17g %d\n", xy[2 * i], xy[2 * i + 1], kind[i]);
    lacuna_free(set);
    return 0;
}
