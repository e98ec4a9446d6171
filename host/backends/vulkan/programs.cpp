// The compute shaders, embedded. The headers are made by cmake/vulkan.cmake.
#include "backends/vulkan/programs.h"

#include <iterator>

namespace lacuna::vulkan {
namespace {

#include "admit.spv.h"
#include "admit_in_cells.spv.h"
#include "cut.spv.h"
#include "find_place_begins.spv.h"
#include "gather.spv.h"
#include "grow.spv.h"
#include "insert.spv.h"
#include "keep.spv.h"
#include "locate.spv.h"
#include "locate_in_boxes.spv.h"
#include "locate_in_cells.spv.h"
#include "look_up_radii.spv.h"
#include "scan.spv.h"
#include "screen.spv.h"
#include "sort_columns.spv.h"
#include "subtract.spv.h"
#include "subtract_in_cells.spv.h"
#include "unfold.spv.h"

}  // namespace

Programs embedded_programs() {
    return {
        {"locate", locate_spirv, 4, sizeof(LocateArguments)},
        {"locate_in_boxes", locate_in_boxes_spirv, 4, sizeof(LocateInBoxesArguments)},
        {"sort_columns", sort_columns_spirv, 6, sizeof(SortColumnsArguments)},
        {"screen", screen_spirv, 5, sizeof(ScreenArguments)},
        {"admit", admit_spirv, 7, sizeof(AdmitArguments)},
        {"gather", gather_spirv, 8, sizeof(GatherArguments)},
        {"subtract", subtract_spirv, 9, sizeof(SubtractArguments)},
        {"grow", grow_spirv, 3, sizeof(GrowArguments)},
        {"insert", insert_spirv, 5, sizeof(InsertArguments)},
        {"unfold", unfold_spirv, 8, sizeof(UnfoldArguments)},
        {"cut", cut_spirv, 10, sizeof(CutArguments)},
        {"keep", keep_spirv, 15, sizeof(KeepArguments)},
        {"scan", scan_spirv, 3, sizeof(ScanArguments)},
        {"find_place_begins", find_place_begins_spirv, 3, sizeof(FindPlaceBeginsArguments)},
        {"locate_in_cells", locate_in_cells_spirv, 4, sizeof(LocateInCellsArguments)},
        {"look_up_radii", look_up_radii_spirv, 5, sizeof(LookUpRadiiArguments)},
        {"admit_in_cells", admit_in_cells_spirv, 11, sizeof(AdmitInCellsArguments)},
        {"subtract_in_cells", subtract_in_cells_spirv, 16, sizeof(SubtractInCellsArguments)},
    };
}

}  // namespace lacuna::vulkan
