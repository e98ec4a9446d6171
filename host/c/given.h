// What a call of lacuna.h is given beside its options, and the options that make one part of a
// request together.
#pragma once

#include <lacuna.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "options/classes.h"
#include "options/targets.h"

namespace lacuna::c {

// Throws BadRequest that names `name` if there are no points but a count.
std::vector<Point> points_of(const char* name, const double* xy, std::size_t count);

// The names of the options whose files a call is given the contents of. The option for importance
// is called `field`: lacuna_sample() and lacuna_verify() have --field, lacuna_relax() has IMAGE.
std::vector<std::string_view> names_of(const lacuna_given* given, std::string_view field);

// What a call is given, as long as the call lasts.
class Given {
public:
    // The domain of the request follows from the field, unless the options have one. Throws
    // BadRequest.
    Given(const lacuna_given* given, Request& request, const options::CommandLine& line);

private:
    std::vector<Point> kept_;
    std::optional<Field> field_;
    std::optional<Mask> mask_;
};

// The options of classes and borders.
class ClassesAndBorders {
public:
    void add_to(options::Targets& targets);
    // The request has its field, if there is one. Throws BadRequest.
    void take_to(Request& request) const;

private:
    options::ClassOptions classes_;
    std::vector<std::string> borders_;
    bool inside_by_radius_ = false;
};

}  // namespace lacuna::c
