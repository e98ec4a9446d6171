// The compute shaders, embedded. The headers are made by cmake/vulkan.cmake.
#include "vulkan/programs.h"

#include <iterator>

namespace lacuna::vulkan {
namespace {

#include "admit.spv.h"
#include "gather.spv.h"
#include "grow.spv.h"
#include "locate.spv.h"
#include "sort_columns.spv.h"
#include "subtract.spv.h"

}  // namespace

Programs embedded_programs() {
    return {
        {"locate", locate_spirv, 3, sizeof(LocateArguments)},
        {"sort_columns", sort_columns_spirv, 4, sizeof(SortColumnsArguments)},
        {"admit", admit_spirv, 5, sizeof(AdmitArguments)},
        {"gather", gather_spirv, 7, sizeof(GatherArguments)},
        {"subtract", subtract_spirv, 8, sizeof(SubtractArguments)},
        {"grow", grow_spirv, 3, sizeof(GrowArguments)},
    };
}

}  // namespace lacuna::vulkan
