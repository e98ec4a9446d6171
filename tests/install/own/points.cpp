// The same function in each library, under the library's name.
#include <lacuna/lacuna.h>

#include <cstddef>

std::size_t POINTS() {
    return lacuna::sample({.radius = 0.05, .seed = 3}).points.size();
}
