// Fails unless both libraries make the same set.
#include <cstddef>

std::size_t points_of_still();
std::size_t points_of_shared();

int main() {
    return points_of_still() == points_of_shared() && points_of_still() > 200 ? 0 : 1;
}
