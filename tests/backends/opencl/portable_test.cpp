// The portable arithmetic on the device equals C++'s, over 2^20 random and extreme inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/opencl/devices.h"
#include "backends/opencl/program.h"
#include "portable/bits.h"
#include "portable/chord.h"
#include "portable/column.h"
#include "portable/distance.h"
#include "portable/failure.h"
#include "portable/isqrt.h"
#include "portable/metric.h"
#include "portable/sample_grid.h"
#include "portable/window.h"

namespace lacuna::opencl {

std::string portable_test_source();  // portable.cl, embedded

namespace {

using namespace lacuna::portable;

struct Input {
    u64 n, radius_squared;
    u32 ax, ay, bx, by, width, height, radius, reach;
    u32 column, line, lines, columns;
};

constexpr std::size_t kOutputs = 35;
using Output = std::array<u64, kOutputs>;

Output on_host(const Input& in) {
    Output out{isqrt(in.n),
               axis_distance(in.ax, in.bx, in.width),
               axis_distance(in.ax, in.bx, 0),
               squared_length(in.ax, in.ay),
               conflicts(in.ax, in.ay, in.bx, in.by, in.width, in.height, in.radius_squared),
               conflicts(in.ax, in.ay, in.bx, in.by, 0, 0, in.radius_squared),
               chord_reach(in.bx, in.radius_squared),
               chord_begin(in.ay, in.reach),
               chord_end(in.ay, in.reach, in.height),
               chord_wrapped_begin(in.ay, in.reach, in.height),
               chord_wrapped_end(in.ay, in.reach, in.height)};
    for (u32 window = 0; window < 3; ++window)
        out[11 + window] = u64{window_low(window, in.ay, in.radius, in.height)} << 32 |
                           window_high(window, in.ay, in.radius, in.height);
    out[14] = first_line_of_column(in.column, in.lines, in.columns);
    out[15] = column_of_line(in.line, in.lines, in.columns);
    out[16] = neighbour_count(in.column, in.columns, 0);
    out[17] = neighbour_count(in.column, in.columns, 1);
    out[18] = first_neighbour(in.column, in.columns, 0);
    out[19] = first_neighbour(in.column, in.columns, 1);
    out[20] = grid_side(in.radius_squared);
    out[21] = count_grid(in.height, in.radius);
    const u32 begin = std::min(in.ay, in.by);
    const u32 end = std::max(in.ay, in.by) + 1;
    for (u32 i = 0; i < 2; ++i) {
        const u32 period = i == 0 ? 0 : in.height;
        const u32 count = count_grid(in.height, in.radius);
        const GridStretch run =
            grid_stretch(begin, end, in.reach, in.height, period, in.radius, count);
        out[22 + i] = u64{run.first} << 32 | run.count;
        out[24] = nth_of_stretch(run, run.count - 1, count);
    }
    out[25] = has_turns_left(in.ay) ? 1 : 0;
    out[26] = word_mask((end - 1) / 32, begin, end);
    out[27] = bit_of_rank(in.radius, (in.ax | in.ay) % count_bits(in.radius));
    const Stretch near = near_lines(in.line, in.reach, in.lines, in.ax);
    out[28] = u64{near.first} << 32 | near.count;
    const Stretch columns = near_columns(near, in.lines, in.columns);
    out[29] = u64{columns.first} << 32 | columns.count;
    const u32 twice =
        twice_metric_radius(in.column % 3, in.radius % 0x20000000u + 1, in.reach % 0x20000000u + 1);
    out[30] = twice;
    out[31] = metric_squared(twice);
    out[32] = bucket_of(in.ay, in.columns, in.height);
    out[33] = radius_class(in.radius);
    out[34] = class_bound(in.radius);
    return out;
}

// Of every magnitude, and often at one end of [0, end).
u64 below(std::mt19937_64& random, u64 end) {
    const u64 kind = random() % 8;
    if (kind == 0) return 0;
    if (kind == 1) return end - 1;
    return (random() >> random() % 64) % end;
}

Input random_input(std::mt19937_64& random) {
    constexpr u64 kLongestSide = u64{1} << 31;
    constexpr u64 kLargestRadius = 3'037'000'500;  // the diagonal
    const auto word = [&](u64 end) { return to_u32(below(random, end)); };
    Input in{};
    in.n = below(random, u64{1} << 63);
    const u64 root = below(random, kLargestRadius);
    if (random() % 2 == 0) in.n = root * root - (root > 0 ? random() % 2 : 0);  // beside a square
    in.width = word(kLongestSide) + 1;
    in.height = word(kLongestSide) + 1;
    in.ax = word(in.width);
    in.bx = word(in.width);
    in.ay = word(in.height);
    in.by = word(in.height);
    in.radius = word(kLargestRadius) + 1;
    in.reach = word(kLargestRadius) + 1;
    in.radius_squared = std::min(u64{in.radius} * in.radius, u64{1} << 63);
    in.lines = word(kLongestSide) + 1;
    in.columns = word(in.lines) + 1;
    in.line = word(in.lines);
    in.column = word(in.columns);
    return in;
}

std::vector<Output> on_device(const Program& program, const std::vector<Input>& inputs) {
    std::vector<Output> outputs(inputs.size());
    const cl::CommandQueue queue(program.context, program.device);
    const std::size_t in_bytes = inputs.size() * sizeof(Input);
    const std::size_t out_bytes = outputs.size() * sizeof(Output);
    const cl::Buffer in(program.context, CL_MEM_READ_ONLY, in_bytes);
    const cl::Buffer out(program.context, CL_MEM_WRITE_ONLY, out_bytes);
    cl::Kernel kernel(program.program, "portable");
    kernel.setArg(0, in);
    kernel.setArg(1, out);
    queue.enqueueWriteBuffer(in, CL_TRUE, 0, in_bytes, inputs.data());
    queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(inputs.size()));
    queue.enqueueReadBuffer(out, CL_TRUE, 0, out_bytes, outputs.data());
    return outputs;
}

class PortableOnOpenCl : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("opencl"); }

    static void expect_equal(const std::string& source) {
        const auto program = compiled(choose_device(""), source);
        std::mt19937_64 random(20);
        std::vector<Input> inputs(std::size_t{1} << 18);
        for (int batch = 0; batch < 4; ++batch) {
            for (Input& input : inputs) input = random_input(random);
            const std::vector<Output> outputs = on_device(*program, inputs);
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                const Output expected = on_host(inputs[i]);
                for (std::size_t k = 0; k < kOutputs; ++k)
                    ASSERT_EQ(expected[k], outputs[i][k])
                        << "output " << k << " of input " << i << ", batch " << batch;
            }
        }
    }
};

TEST_F(PortableOnOpenCl, EqualsCppOnRandomAndExtremeInputs) {
    expect_equal(portable_test_source());
}

TEST_F(PortableOnOpenCl, EqualsCppOnDevicesThatHaveNoDoubles) {
    expect_equal("#undef cl_khr_fp64\n" + portable_test_source());
}

}  // namespace
}  // namespace lacuna::opencl
