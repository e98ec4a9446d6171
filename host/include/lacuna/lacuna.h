// The public API of Lacuna: a request goes in, a blue-noise point set comes out.
//
// What is promised
//   - The same request and seed give the same points, bit for bit, on every backend, every device
//     and any number of threads.
//   - Points come in the order in which they were admitted; any prefix of a set is itself an
//     unbiased Poisson-disk set.
//   - Every point lies in [0, width) x [0, height).
//   - Mode::exact: no two points are closer than the radius, computed in double from the points
//     returned, and no place of the domain is farther than the radius, plus 2^-28 of the longer
//     side, from a point. Sets are distributed as dart throwing's, carried on until no room is
//     left.
//     With a field, a mask, a border or kept points the same holds of radii that are each pixel's
//     own: two points are no closer than the smaller of their radii, each lies where samples may,
//     and every place where one may is closer to some point than the smaller of that point's radius
//     and its own, but for 2^-28 of the longer side; within so much of a pixel's border a place may
//     count for either pixel.
//   - Mode::lines with Request::snap: no two points are closer than the radius. Without snap
//     (Kalantari & Sen 2011, section 4.1, x interpolated in its strip) no two points are closer
//     than radius * (1 - 1 / (2 * lines_per_radius)). Gaps narrower than a strip remain.
//   - Mode::cells: points lie on a lattice. Every two keep the distance that the metric asks of
//     their radii, computed in double from the coordinates returned, and every lattice point with
//     importance is closer to some point than the metric allows, in lattice steps and with radii
//     rounded up to 1/256 of one. Where importance is 0, no point is.
//   - The library never prints, never exits and never reads the clock.
//   - Any function may be called from several threads at once. A process forked after a device was
//     used or listed gets Unavailable for opencl and vulkan: drivers' threads do not live on there.
//
// What can go wrong is thrown: see the classes derived from Error at the end of this file.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

// A position in the user's own units.
struct Point {
    double x;
    double y;
    friend bool operator==(const Point&, const Point&) = default;
};

// What happens at the edges of the domain: they wrap (torus) or they do not (box).
enum class Boundary { box, torus };

// Importance over the domain: where samples are wanted, and how densely (section 4.2).
struct Field {
    std::uint32_t columns = 0;       // pixels
    std::uint32_t rows = 0;          // pixels
    std::vector<double> importance;  // rows * columns values, finite, >= 0 (0: no sample there);
                                     // row by row, row 0 is the top of the picture (largest y)
};

// Where samples may lie, whatever the importance: pixels that are stretched over the domain. One on
// the border of two pixels lies in the right one, and in the upper one.
struct Mask {
    std::uint32_t columns = 0;          // pixels
    std::uint32_t rows = 0;             // pixels
    std::vector<std::uint8_t> allowed;  // rows * columns values, of which one at least is not 0 (0:
                                        // no sample there); row by row, row 0 is the top of the
                                        // picture (largest y)
};

// How the free space is cut up.
//   exact  strips, then boxes, refined until none has room: sets that are truly maximal
//   lines  the paper's section 4.1: one line stands for its whole strip
//   cells  the paper's section 4.2, for Request::field: a lattice, fine enough for the least radius
enum class Mode { exact, lines, cells };
std::string_view name_of(Mode mode);

// Which distance two points of different radii must keep (section 4.2.1): the smaller radius (the
// paper's), their mean, or the larger.
enum class Metric { min, mean, max };
std::string_view name_of(Metric metric);

// What is wanted. Exactly one of radius, scale and count must be set.
struct Request {
    double width = 1.0;   // of the domain, > 0
    double height = 1.0;  // of the domain, > 0; neither side over 1000 times the other
    Boundary boundary = Boundary::box;

    // Least distance between two points, in the unit of width and height; not in cells. At least
    // 2^-20 of the longer side, at most the shorter side of a torus or the diagonal of a box.
    std::optional<double> radius;
    std::optional<std::uint64_t> count;  // exactly this many points, at a radius chosen to fit

    Mode mode = Mode::exact;
    // In modes exact and cells: importance, stretched over the domain. It must outlive the call. In
    // exact the radius is constant on a pixel, and the metric min.
    const Field* field = nullptr;
    // The paper's g (section 4.2): the radius of a place is g / sqrt(importance there), in the unit
    // of width and height. Where the importance is 1 it is the radius itself.
    std::optional<double> scale;
    Metric metric = Metric::min;
    // The paper's m, 1 to 1000. Unset: 6 in exact, where it decides nothing but the speed, the
    // paper's 30 in lines, and 10 to the least radius in cells. In exact with a field, a mask, a
    // border or kept points there are no lines: unset, 1, it tells how many of the first boxes two
    // radii are long, and again decides nothing but the speed.
    std::optional<std::uint32_t> lines_per_radius;
    // In mode lines only.
    bool snap = false;       // points on the lines themselves: keeps every distance >= radius
    bool uniform_x = false;  // end of section 4.1: lines with room are equally likely

    // In mode exact only, all three; together they say where samples may lie, and the set is
    // maximal there: no place that is left has room for another sample. Samples lie on pixels of
    // the mask that are not 0. It must outlive the call.
    const Mask* mask = nullptr;
    // Least distance of samples to each edge of the domain, in the unit of width and height; in a
    // box only, and under half of its shorter side. 0: samples lie up to the edges.
    double border = 0;
    // Points that are there already: they come first in the result, in this order and to the bit,
    // samples keep their distance from them as from each other, and fill what they leave. Each must
    // lie in the domain, where samples may, and keep its distance from the others. They count for
    // limit and count. They must outlive the call.
    std::span<const Point> keep;

    std::optional<std::uint64_t> limit;  // stop after this many points, >= 1
    std::uint64_t round_size = 0;        // draws a round; 0 chooses, 1 is the paper's algorithm
    std::uint64_t seed = 0;

    // A Device::backend of devices(); "auto" is what the environment variable LACUNA_BACKEND names
    // or, where it is unset or empty, the first of them.
    std::string backend = "auto";
    std::string device;         // for backends with devices: a number or part of a name
    std::uint32_t threads = 0;  // at most 1024; 0: as many as the machine has

    std::uint64_t memory_limit_bytes = 0;  // refuse a larger set; 0: the machine's memory
};

// What was made, and how.
struct Result {
    std::vector<Point> points;  // in order of admission
    // The radius asked for, or chosen for Request::count; in cells the least of all radii.
    double radius = 0;
    double scale = 0;                    // in cells: the g asked for, or chosen for Request::count
    std::uint32_t lines_per_radius = 0;  // the m asked for, or the mode's own
    bool maximal = false;  // false when a limit or a count stopped it before the room ran out
    // Of the run that made the set, not of those that chose a radius for Request::count: rounds of
    // draws from one cdf (docs/design.md, section 3), and inversions of the cdf, whether a point
    // came of them or not.
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    std::string backend;  // the name of the backend that did the work
    std::string device;   // the name of its device
};

// The parts of a round, and of an iteration of relax, for those who time them.
enum class Verb {
    invert,
    locate,
    admit,
    subtract,
    refine,
    transfer,
    first_use,
    assign,
    accumulate,
    move
};
std::string_view name_of(Verb verb);

struct Progress {
    std::uint64_t points;           // admitted so far
    std::uint64_t expected_points;  // an estimate, at least `points`
    std::uint64_t rounds;           // finished so far
};

// Watches a run from the calling thread. The library has no clock: an observer that wants times
// reads its own in begin and end.
class Observer {
public:
    virtual ~Observer() = default;
    // Called after each round, and now and then within long ones. Return false to cancel: sample()
    // then asks no more and throws Cancelled.
    virtual bool keep_going(const Progress&) { return true; }
    virtual void begin(Verb) {}
    virtual void end(Verb) {}
    // Each may throw: that ends sample(), which passes the exception on. What end() throws while
    // another exception is on its way is lost.
};

// Makes the set that `request` asks for.
// Throws BadRequest, of which MemoryRefused is one, Unavailable, DeviceError, Cancelled.
Result sample(const Request& request);
Result sample(const Request& request, Observer& observer);

// How points are relaxed: see relax.
struct RelaxOptions {
    double width = 1.0;  // of the domain, as in Request
    double height = 1.0;
    Boundary boundary = Boundary::box;

    std::uint32_t iterations = 15;  // 0 to 10,000; 0 leaves the points as they are

    // As in Request: "auto", or a backend by name.
    std::string backend = "auto";
    std::string device;
    std::uint32_t threads = 0;

    bool measure = false;  // fill in Relaxed::evenness, which costs two more looks at the lattice
};

// How equal the points' shares of the importance are: coefficients of variation, the standard
// deviation over the mean. 0 when all shares are equal.
struct Evenness {
    double before;         // of the importance in the points' Voronoi cells
    double after;          // in the power cells that relax ends with
    double after_voronoi;  // in the Voronoi cells of the points that it ends with
};

struct Relaxed {
    std::vector<Point> points;  // in the order given
    std::uint64_t lattice_columns = 0;
    std::uint64_t lattice_rows = 0;
    std::optional<Evenness> evenness;
    std::string backend;
    std::string device;
};

// Moves points until each owns an equal share of the importance and sits in its middle: a
// centroidal power diagram with equal capacities, found on a lattice in whole numbers, so that the
// same points come back on every backend and any number of threads. Without a field importance is
// the same everywhere. What is promised: as many points as were given, each in the domain; and,
// once anything moves, none where importance is 0. A least distance is not promised.
// Progress counts points times iterations. Throws what sample throws.
Relaxed relax(std::span<const Point> points, const Field* field, const RelaxOptions& options);
Relaxed relax(std::span<const Point> points, const Field* field, const RelaxOptions& options,
              Observer& observer);

// A device that a backend can run on, or what stands where one was hoped for.
struct Device {
    std::string backend;
    std::string name;  // as the driver gives it
    std::string kind;  // cpu, gpu or other
    std::uint64_t memory_bytes = 0;
    std::uint64_t largest_buffer_bytes = 0;
    std::string unusable;  // why it cannot be used; empty when it can
};

// Every backend's devices: backends in order of preference, the devices of one by number, which is
// what Request::device may name. A backend that this build lacks, or whose driver fails, has one
// entry that says so.
std::vector<Device> devices();

// The number of points to expect of a maximal set, all lengths in one unit: 0.69656 to a squared
// radius on the torus (random sequential adsorption's jamming limit), with an edge term on the box
// (docs/design.md, section 5). Counts have a standard deviation of 0.244 sqrt(count) around it.
double expected_count(double width, double height, Boundary boundary, double radius);

// ---------------------------------------------------------------------------------------- errors

class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The request cannot be met. what() is "OPTION VALUE: what is allowed"; option() is the command's
// name for the field, without dashes.
class BadRequest : public Error {
public:
    BadRequest(const std::string& option, const std::string& value, const std::string& allowed)
        : Error(option + " " + value + ": " + allowed), option_(option) {}
    const std::string& option() const { return option_; }

private:
    std::string option_;
};

// The set asked for would take more memory than there is, or than Request::memory_limit_bytes.
class MemoryRefused : public BadRequest {
    using BadRequest::BadRequest;
};

// The backend or device asked for is not there.
class Unavailable : public Error {
    using Error::Error;
};

// A device failed in the middle of the work; names the call, the code and the driver's log.
class DeviceError : public Error {
    using Error::Error;
};

// Observer::keep_going returned false.
class Cancelled : public Error {
public:
    Cancelled() : Error("cancelled") {}
};

}  // namespace lacuna
