// Classes of points by lacuna.h: refuted, kept and refused. That they are those of the library and
// proven is judged by hostile.
#include <gtest/gtest.h>
#include <lacuna.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace lacuna;

const std::string kTreesAndGrass = "--class trees:0.06 --class grass:0.02:3";

// What a call made, in C++'s terms.
struct MadeInC {
    std::vector<Point> points;
    std::vector<unsigned char> classes;
    lacuna_facts facts;
    bool has_classes;
};

MadeInC made_in_c(const std::string& options, const lacuna_given* given = nullptr) {
    const std::unique_ptr<lacuna_set, void (*)(lacuna_set*)> set(
        lacuna_sample(options.c_str(), given), lacuna_free);
    EXPECT_NE(set, nullptr) << options << ": " << lacuna_error();
    MadeInC made{{}, {}, lacuna_describe(set.get()), lacuna_layers(set.get()) != nullptr};
    const std::size_t count = lacuna_count(set.get());
    const double* const xy = lacuna_points(set.get());
    for (std::size_t i = 0; i < count; ++i) made.points.push_back({xy[2 * i], xy[2 * i + 1]});
    if (made.has_classes)
        made.classes.assign(lacuna_layers(set.get()), lacuna_layers(set.get()) + count);
    return made;
}

// Of an array that outlives the result.
const double* numbers_of(const std::vector<Point>& points) {
    return points.empty() ? nullptr : &points.front().x;
}

int verify(const std::string& options, const MadeInC& made, lacuna_given given = {}) {
    given.classes = made.classes.data();
    return lacuna_verify(options.c_str(), &given, numbers_of(made.points), made.points.size());
}

TEST(CountsOfClassesInC, AreProvenAtTheirRadius) {
    const MadeInC made = made_in_c(kTreesAndGrass + " --count 150");
    EXPECT_EQ(made.points.size(), 150);
    const std::string radius = " --radius " + std::to_string(made.facts.radius * 0.999);
    EXPECT_EQ(verify(kTreesAndGrass + radius + " --distances-only", made), 1) << lacuna_error();
}

TEST(OneClassInC, HasAClassForEachPoint) {
    const MadeInC made = made_in_c("--class=trees:0.05");
    EXPECT_EQ(made.classes, std::vector<unsigned char>(made.points.size(), 0));
    EXPECT_EQ(verify("--class trees:0.05", made), 1) << lacuna_error();
    EXPECT_FALSE(made_in_c("--radius 0.1").has_classes);
}

TEST(AChangedClassInC, IsRefuted) {
    const MadeInC made = made_in_c(kTreesAndGrass);
    const auto with_a_change = [&](unsigned char from) {
        MadeInC changed = made;
        *std::find(changed.classes.begin(), changed.classes.end(), from) ^= 1;
        EXPECT_EQ(verify(kTreesAndGrass, changed), 0);
        return std::string(lacuna_error());
    };
    EXPECT_NE(with_a_change(1).find("apart, less than 0.08"), std::string::npos) << lacuna_error();
    EXPECT_NE(with_a_change(0).find("there is room for a point of class grass at ("),
              std::string::npos)
        << lacuna_error();
}

TEST(KeptPointsOfClassesInC, ComeFirstWithTheirClasses) {
    // One lies beside the domain.
    const std::vector<Point> kept{{0.2, 0.2}, {1.02, 0.5}, {0.6, 0.7}};
    const std::vector<unsigned char> classes{1, 0, 0};
    lacuna_given given{};
    given.kept = numbers_of(kept);
    given.kept_count = kept.size();
    given.kept_classes = classes.data();
    const MadeInC made = made_in_c(kTreesAndGrass, &given);
    EXPECT_EQ(made.points[0], kept[0]);
    EXPECT_EQ(made.points[1], kept[2]);
    EXPECT_EQ(made.classes[1], 0);
    EXPECT_EQ(verify(kTreesAndGrass, made, given), 1) << lacuna_error();
    const std::vector<unsigned char> other{1, 1, 0};
    given.kept_classes = other.data();
    EXPECT_EQ(verify(kTreesAndGrass, made, given), 0) << "the neighbour's class has changed";
}

// The error of a set that is not made.
std::string refusal(const std::string& options, const lacuna_given& given = {}) {
    const lacuna_set* const set = lacuna_sample(options.c_str(), &given);
    return set == nullptr ? lacuna_error() : "accepted";
}

TEST(OptionsOfClassesInC, AreRefusedInOneLine) {
    EXPECT_EQ(refusal("--class trees:0.1 --between distances.csv"),
              "between distances.csv: must be sum or union, as lacuna.h reads no files");
    EXPECT_EQ(refusal("--class trees"), "class trees: needs a radius: give NAME:RADIUS");
    EXPECT_EQ(refusal("--class trees:-1"),
              "class trees:-1: its radius must be a finite number over 0");
    EXPECT_EQ(refusal("--class a:1:2:3"),
              "class a with 3 points: is the only class: give a limit instead");
    EXPECT_EQ(refusal("--class a:0.1 --border b:1"),
              "border b:1: must be D, or NAME:D with the name of a class (a)");
    EXPECT_EQ(refusal("--radius 0.1 --border 0.1 --border 0.2"), "border 0.2: is given twice");
    for (const char* const options :
         {"--class", "--class a:0.1 --radius 0.1", "--between sum --radius 0.1",
          "--class a:0.1 --class a:0.2", "--class a:0.1 --mode lines", "--class a:0.1 --relax 3",
          "--class a:0.1 --inside-by-radius --torus", "--class a:0.1 --inside-by-radius=yes"}) {
        EXPECT_NE(refusal(options), "accepted") << options;
        EXPECT_EQ(refusal(options).find('\n'), std::string::npos) << options;
    }
}

TEST(ClassesGivenInC, AreRefusedWhereTheyHaveNoUse) {
    const Point one{0.5, 0.5};
    const unsigned char kind = 0;
    const unsigned char stranger = 2;
    lacuna_given given{};
    given.kept = &one.x;
    given.kept_count = 1;
    EXPECT_EQ(refusal(kTreesAndGrass, given),
              "keep 1 points: with classes each needs a class, but 0 have one");
    given.kept_classes = &kind;
    EXPECT_EQ(refusal("--radius 0.1", given), "classes given: are for options with --class");
    given.kept_classes = &stranger;
    EXPECT_EQ(refusal(kTreesAndGrass, given),
              "keep class 2: must be less than 2, the number of classes");
    given = {};
    given.classes = &kind;
    EXPECT_EQ(refusal(kTreesAndGrass, given),
              "classes given: are those of the points that lacuna_verify() proves");
    EXPECT_EQ(lacuna_relax("", &given, &one.x, 1), nullptr);
    EXPECT_STREQ(lacuna_error(), "classes given: are for options with --class");

    const auto unproven = [&](const std::string& options) {
        EXPECT_EQ(lacuna_verify(options.c_str(), &given, &one.x, 1), -1) << options;
        return std::string(lacuna_error());
    };
    EXPECT_EQ(unproven("--radius 0.1"), "classes given: are for options with --class");
    given.classes = &stranger;
    EXPECT_EQ(unproven(kTreesAndGrass), "class 2: must be less than 2, the number of classes");
    given.classes = nullptr;
    EXPECT_EQ(unproven(kTreesAndGrass), "class 0 points: have a class, but there are 1 points");
}

}  // namespace
