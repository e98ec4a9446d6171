// What all calls of lacuna.h share: the sets that they return, their errors, and who watches them.
#pragma once

#include <lacuna.h>
#include <lacuna/lacuna.h>
#include <lacuna/space.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <vector>

struct lacuna_set {
    std::vector<lacuna::Point> points{};
    std::vector<lacuna::Point3> in_space{};  // in place of the points of the plane
    std::vector<unsigned> triangles{};
    std::vector<double> diameters{};
    std::vector<unsigned char> layers{};
    lacuna_facts facts{};
};

namespace lacuna::c {

inline thread_local std::string error_of_thread;
inline thread_local std::function<bool(double)> watch_of_thread;

class Watched : public Observer {
public:
    bool keep_going(const Progress& progress) override {
        const auto all = static_cast<double>(std::max<std::uint64_t>(1, progress.expected_points));
        return !watch_ || watch_(std::min(1.0, static_cast<double>(progress.points) / all));
    }

private:
    const std::function<bool(double)>& watch_ = watch_of_thread;
};

// Runs a function of the interface. What it throws becomes the thread's error, and `failed` is
// returned.
template <typename Call, typename Returned>
Returned guarded(Returned failed, Call call) noexcept {
    try {
        error_of_thread.clear();
        return call();
    } catch (const std::exception& error) {
        try {
            error_of_thread = error.what();
        } catch (const std::bad_alloc&) {
            error_of_thread.clear();  // the text itself has no room
        }
    }
    return failed;
}

}  // namespace lacuna::c
