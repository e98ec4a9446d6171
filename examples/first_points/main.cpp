// Fills the unit torus with points at least 0.05 apart; prints how many fit and where the first is.
#include <lacuna/lacuna.h>

#include <cstdio>

int main() {
    lacuna::Request request;
    request.radius = 0.05;
    request.domain.boundary = lacuna::Boundary::torus;
    const lacuna::Result result = lacuna::sample(request);
    const lacuna::Point first = result.points.front();
    std::printf("%zu points\n%.17g %.17g\n", result.points.size(), first.x, first.y);
}
