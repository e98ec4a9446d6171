// Stipples a picture, writes the dots, reads them back and checks their distances and spectrum.
//   stippled_picture PICTURE POINTS
#include <lacuna/analysis.h>
#include <lacuna/files.h>
#include <lacuna/lacuna.h>
#include <lacuna/pictures.h>
#include <lacuna/verify.h>

#include <cstdio>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: stippled_picture PICTURE POINTS\n");
        return 2;
    }
    try {
        const lacuna::Field field = lacuna::read_field(argv[1]);
        lacuna::Request request;
        request.mode = lacuna::Mode::cells;
        request.field = &field;
        request.width = static_cast<double>(field.columns) / field.rows;
        request.count = 2000;
        const lacuna::Result result = lacuna::sample(request);
        lacuna::write_points(argv[2], result.points, {request.width, 1, result.radius});

        lacuna::Claim claim;
        claim.radius = result.radius;
        claim.width = request.width;
        claim.distances_only = true;
        const lacuna::Proof proof = lacuna::prove(lacuna::read_points(argv[2]), claim);
        const std::vector<lacuna::Point> sets[] = {result.points};
        const lacuna::Statistics statistics = lacuna::analyze(sets, request.width, 1);
        std::printf("%zu points, distances kept: %s, %zu rings of the spectrum\n",
                    result.points.size(), proof.kept ? "yes" : "no", statistics.rings.size());
    } catch (const lacuna::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
