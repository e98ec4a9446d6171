// How a device is chosen from a list, by number or by part of a name.
#include "backends/device/choice.h"

#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <vector>

namespace lacuna::device {
namespace {

DeviceEntry entry(const std::string& name, const std::string& kind,
                  const std::string& unusable = "") {
    DeviceEntry made;
    made.name = name;
    made.kind = kind;
    made.unusable = unusable;
    return made;
}

const std::vector<DeviceEntry> kEntries = {entry("Broken GPU", "gpu", "no driver"),
                                           entry("Xeon 6000", "cpu"), entry("Radeon 9070", "gpu"),
                                           entry("Radeon 7600", "gpu")};

std::string refusal(std::span<const DeviceEntry> entries, std::string_view wanted) {
    try {
        choose("opencl", entries, wanted);
    } catch (const Unavailable& error) {
        return error.what();
    }
    return "";
}

TEST(Choice, PrefersTheFirstUsableGpu) {
    EXPECT_EQ(choose("opencl", kEntries, ""), 2u);
}

TEST(Choice, TakesAnythingUsableWhereThereIsNoGpu) {
    EXPECT_EQ(choose("opencl", std::span(kEntries).first(2), ""), 1u);
}

TEST(Choice, TakesANumber) {
    EXPECT_EQ(choose("opencl", kEntries, "3"), 3u);
}

TEST(Choice, TakesPartOfANameInAnyCase) {
    EXPECT_EQ(choose("opencl", kEntries, "xeon"), 1u);
    EXPECT_EQ(choose("opencl", kEntries, "radeon 76"), 3u);
}

TEST(Choice, TakesANumberBeyondTheListAsPartOfAName) {
    EXPECT_EQ(choose("opencl", kEntries, "9070"), 2u);
}

TEST(Choice, RefusesWhatNothingIsCalled) {
    EXPECT_EQ(refusal(kEntries, "Arc"),
              "device Arc: must be the number or part of the name of one that backend opencl has: "
              "0 (Broken GPU: no driver), 1 (Xeon 6000), 2 (Radeon 9070), 3 (Radeon 7600)");
    EXPECT_NE(refusal(kEntries, "4"), "");
    EXPECT_NE(refusal(kEntries, "-1"), "");
}

TEST(Choice, RefusesWhatSeveralAreCalled) {
    EXPECT_EQ(refusal(kEntries, "radeon").find("device radeon: is part of several names"), 0u);
}

TEST(Choice, RefusesAnUnusableDeviceWithTheReason) {
    for (const char* const wanted : {"0", "broken"})
        EXPECT_EQ(refusal(kEntries, wanted), std::string("device ") + wanted +
                                                 ": Broken GPU cannot be used by backend opencl: "
                                                 "no driver");
}

TEST(Choice, SaysWhyThereIsNothingToChooseFrom) {
    EXPECT_EQ(refusal({}, ""), "backend opencl: no device: no driver for it is installed");
    EXPECT_EQ(refusal(std::span(kEntries).first(1), ""),
              "backend opencl: no device can be used: 0 (Broken GPU: no driver)");
}

}  // namespace
}  // namespace lacuna::device
