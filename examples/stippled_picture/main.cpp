// Stipples a photograph in four inks.
//   stippled_picture PICTURE DOTS.svg
#include <lacuna/stipple.h>

#include <cstdio>

int main(int argc, char** argv) try {
    if (argc != 3) throw lacuna::Error("usage: stippled_picture PICTURE DOTS.svg");
    const lacuna::Picture photograph = lacuna::read_picture(argv[1]);
    lacuna::StippleOptions options{.inks = lacuna::inks_of("cmyk")};
    options.request.count = 20000;
    lacuna::write_stippling(argv[2], lacuna::stipple(photograph, options));
} catch (const lacuna::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
