// Classes of points by lacuna.h: refuted, kept and refused. That they are those of the library and
// proven is judged by hostile; options are refused by tests/refusals.txt.
#include <gtest/gtest.h>
#include <lacuna.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace lacuna;

const std::string kWood = "--class trees:0.06 --class grass:0.02:3";

class ClassesInC : public testing::Test {
protected:
    void make(const std::string& options) {
        set_.reset(lacuna_sample(options.c_str(), &given_));
        ASSERT_NE(set_, nullptr) << options << ": " << lacuna_error();
        const unsigned char* const layers = lacuna_layers(set_.get());
        if (layers != nullptr) classes_.assign(layers, layers + lacuna_count(set_.get()));
    }
    // 1 if proven; lacuna_error() says why not.
    int verify(const std::string& options) {
        lacuna_given given = given_;
        given.classes = classes_.data();
        return lacuna_verify(options.c_str(), &given, lacuna_points(set_.get()),
                             lacuna_count(set_.get()));
    }
    // The error of a set that is not made.
    std::string refusal(const std::string& options) const {
        return lacuna_sample(options.c_str(), &given_) == nullptr ? lacuna_error() : "accepted";
    }
    std::string unproven(const std::string& options) const {
        EXPECT_EQ(lacuna_verify(options.c_str(), &given_, &kOne.x, 1), -1) << options;
        return lacuna_error();
    }

    static constexpr Point kOne{0.5, 0.5};
    std::unique_ptr<lacuna_set, void (*)(lacuna_set*)> set_{nullptr, lacuna_free};
    std::vector<unsigned char> classes_;
    lacuna_given given_{};
};

TEST_F(ClassesInC, AreOnesOfPointsIfThereIsOneAndNoneWithoutAny) {
    make("--class=trees:0.05");
    EXPECT_EQ(classes_, std::vector<unsigned char>(lacuna_count(set_.get()), 0));
    EXPECT_EQ(verify("--class trees:0.05"), 1) << lacuna_error();
    make("--radius 0.1");
    EXPECT_EQ(lacuna_layers(set_.get()), nullptr);
}

TEST_F(ClassesInC, ThatChangeAreRefuted) {
    for (const auto& [from, told] :
         {std::pair<unsigned char, const char*>{1, "apart, less than 0.08"},
          {0, "there is room for a point of class grass at ("}}) {
        make(kWood);
        *std::find(classes_.begin(), classes_.end(), from) ^= 1;
        EXPECT_EQ(verify(kWood), 0);
        EXPECT_NE(std::string(lacuna_error()).find(told), std::string::npos) << lacuna_error();
    }
}

TEST_F(ClassesInC, OfKeptPointsComeFirst) {
    // One lies beside the domain.
    const std::vector<Point> kept{{0.2, 0.2}, {1.02, 0.5}, {0.6, 0.7}};
    const unsigned char classes[]{1, 0, 0}, other[]{1, 1, 0};
    given_.kept = &kept.front().x;
    given_.kept_count = kept.size();
    given_.kept_classes = classes;
    make(kWood);
    EXPECT_EQ(lacuna_points(set_.get())[0], 0.2);
    EXPECT_EQ(lacuna_points(set_.get())[2], 0.6);
    EXPECT_EQ(classes_[1], 0);
    EXPECT_EQ(verify(kWood), 1) << lacuna_error();
    given_.kept_classes = other;
    EXPECT_EQ(verify(kWood), 0) << "the neighbour's class has changed";
}

TEST_F(ClassesInC, AreRefusedWhereTheyHaveNoUse) {
    const unsigned char kind = 0, stranger = 2;
    EXPECT_EQ(refusal("--class trees:0.1 --between distances.csv"),
              "between distances.csv: must be sum or union, as lacuna.h reads no files");
    given_.kept = &kOne.x;
    given_.kept_count = 1;
    EXPECT_EQ(refusal(kWood), "keep 1 points: with classes each needs a class, but 0 have one");
    given_.kept_classes = &kind;
    EXPECT_EQ(refusal("--radius 0.1"), "classes given: are for options with --class");
    given_.kept_classes = &stranger;
    EXPECT_EQ(refusal(kWood), "keep class 2: must be less than 2, the number of classes");
    given_ = {};
    given_.classes = &kind;
    EXPECT_EQ(refusal(kWood), "classes given: are those of the points that lacuna_verify() proves");
    EXPECT_EQ(lacuna_relax("", &given_, &kOne.x, 1), nullptr);
    EXPECT_STREQ(lacuna_error(), "classes given: are for options with --class");
    EXPECT_EQ(unproven("--radius 0.1"), "classes given: are for options with --class");
    given_.classes = &stranger;
    EXPECT_EQ(unproven(kWood), "class 2: must be less than 2, the number of classes");
    given_.classes = nullptr;
    EXPECT_EQ(unproven(kWood), "class 1 points: with classes each needs a class, but 0 have one");
}

}  // namespace
