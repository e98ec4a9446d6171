// The kernels of the backend, made from the shaders.
#pragma once

#include "backends/vulkan/engine.h"
#include "backends/vulkan/programs.h"

namespace lacuna::vulkan {

struct Kernels {
    // Those that mode exact alone needs are made for it alone.
    Kernels(Engine& engine, const Programs& programs, bool exact)
        : locate(engine.make_kernel(programs.locate)),
          sort_columns(engine.make_kernel(programs.sort_columns)),
          admit(engine.make_kernel(programs.admit)),
          gather(engine.make_kernel(programs.gather)),
          subtract(engine.make_kernel(programs.subtract)),
          grow(engine.make_kernel(programs.grow)) {
        if (!exact) return;
        locate_in_boxes = engine.make_kernel(programs.locate_in_boxes);
        screen = engine.make_kernel(programs.screen);
        insert = engine.make_kernel(programs.insert);
        unfold = engine.make_kernel(programs.unfold);
        cut = engine.make_kernel(programs.cut);
        keep = engine.make_kernel(programs.keep);
        scan = engine.make_kernel(programs.scan);
        find_place_begins = engine.make_kernel(programs.find_place_begins);
    }

    Kernel locate, sort_columns, admit, gather, subtract, grow;
    Kernel locate_in_boxes, screen, insert, unfold, cut, keep, scan, find_place_begins;
};

// Those of mode cells.
struct CellsKernels {
    CellsKernels(Engine& engine, const Programs& programs)
        : locate(engine.make_kernel(programs.locate_in_cells)),
          sort_columns(engine.make_kernel(programs.sort_columns)),
          look_up_radii(engine.make_kernel(programs.look_up_radii)),
          admit(engine.make_kernel(programs.admit_in_cells)),
          subtract(engine.make_kernel(programs.subtract_in_cells)) {}

    Kernel locate, sort_columns, look_up_radii, admit, subtract;
};

}  // namespace lacuna::vulkan
