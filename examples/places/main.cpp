// Trees and bushes in a park with a pond, off the road and near the fence, from arrays in memory.
#include <lacuna/lacuna.h>

#include <cstdio>
#include <vector>

int main() {
    using lacuna::Role;
    const std::vector<lacuna::PolygonRing> park{
        {{0, 0}, {90, 5}, {100, 70}, {10, 80}},
        {{40, 30}, {60, 30}, {50, 45}}};  // a hole: the pond
    const std::vector<lacuna::PolygonRing> road{{{0, 60}, {100, 20}}}, fence{{{10, 10}, {85, 12}}};
    lacuna::Request request;
    request.classes = {.names = {"trees", "bushes"},
                       .distances = lacuna::distances_by_sum(std::vector{2.5, 0.8})};
    request.places.outlines = {
        {.polygons = {park}},
        {.polygons = {road}, .role = Role::avoid, .distance = 3},
        {.polygons = {fence}, .role = Role::near, .distance = 25},
    };
    request.domain = lacuna::domain_around(request.places);
    const lacuna::Result set = lacuna::sample(request);
    for (std::size_t i = 0; i < set.points.size(); ++i)
        std::printf("%.17g %.17g %d\n", set.points[i].x, set.points[i].y, set.classes[i]);
}
