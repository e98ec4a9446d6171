# Script: PROGRAM, and the test program TESTS, make small sets under Oclgrind, which must find no
# race, no use of uninitialized memory and no access out of bounds. Only its log shows this. SCRATCH
# is a folder to write to.
find_program(OCLGRIND oclgrind)
if(NOT OCLGRIND)
    if("$ENV{LACUNA_REQUIRE}" MATCHES "oclgrind")
        message(FATAL_ERROR "LACUNA_REQUIRE has oclgrind, but oclgrind is not installed")
    endif()
    message("SKIPPED: oclgrind is not installed")
    return()
endif()
file(MAKE_DIRECTORY ${SCRATCH})
set(log ${SCRATCH}/oclgrind.log)

# Runs the command under Oclgrind, and sets `printed` to what it prints.
function(run_under_oclgrind)
    file(REMOVE ${log})
    # Without optimisation: Oclgrind does not know all whole-number code that its compiler makes.
    execute_process(
        COMMAND ${OCLGRIND} --build-options -cl-opt-disable --data-races --uninitialized
            --log ${log} ${ARGN}
        RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "${ARGN}: exit code ${code}: ${errors}${output}")
    endif()
    if(NOT EXISTS ${log})
        message(FATAL_ERROR "${ARGN}: oclgrind has left no log")
    endif()
    file(READ ${log} found)
    if(NOT found STREQUAL "")
        message(FATAL_ERROR "${ARGN}: oclgrind says: ${found}")
    endif()
    set(printed "${output}" PARENT_SCOPE)
endfunction()

function(check)
    run_under_oclgrind(${PROGRAM} ${ARGN} --backend opencl --quiet)
    execute_process(COMMAND ${PROGRAM} ${ARGN} --backend cpu --quiet
        OUTPUT_VARIABLE expected COMMAND_ERROR_IS_FATAL ANY)
    if(NOT printed STREQUAL expected)
        message(FATAL_ERROR "${ARGN}: not the points of the cpu backend")
    endif()
endfunction()

# Rounds of one size: Oclgrind takes a buffer for uninitialized where one was released before, or
# where the host filled it after the first kernel ran.
check(sample --mode lines --radius 0.2 --lines-per-radius 2 --torus --round-size 16)
check(sample --mode lines --radius 0.2 --lines-per-radius 2 --round-size 16)
check(sample --mode lines --radius 0.06 --lines-per-radius 3 --round-size 64)
check(sample --mode lines --radius 0.4 --lines-per-radius 5 --torus --round-size 1)
check(sample --mode exact --radius 0.2 --lines-per-radius 2 --torus --round-size 16)
check(sample --mode exact --radius 0.08 --lines-per-radius 3 --round-size 64)

# With a radius field: a triangle as a mask, a border, and kept points.
file(WRITE ${SCRATCH}/triangle.txt "0.1 0.1\n0.9 0.2\n0.4 0.95\n")
file(WRITE ${SCRATCH}/kept.txt "0.4 0.4\n0.6 0.4\n")
check(sample --radius 0.15 --inside ${SCRATCH}/triangle.txt --edge 0.05 --border 0.05
    --keep ${SCRATCH}/kept.txt --round-size 16)
check(sample --radius 0.15 --inside ${SCRATCH}/triangle.txt --edge 0.05 --torus --round-size 16)

# Ellipses: one everywhere, and one for each pixel.
check(sample --stretch 0.3:0.1@30 --torus --round-size 16)
file(WRITE ${SCRATCH}/stripes.pgm "P2 4 3 255 0 90 180 90 0 90 180 90 60 0 90 200")
check(sample --field ${SCRATCH}/stripes.pgm --scale 0.16 --along 4 --round-size 16)

# Surfaces, with kept points and a triangle without area, and volumes.
file(WRITE ${SCRATCH}/roof.obj
    "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0.5\nv 1 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\nf 4 3 5 6\nf 1 2 2\n")
file(WRITE ${SCRATCH}/on_roof.txt "0.5 0.5 0.25\n0.5 1.5 0.25\n")
check(sample --on ${SCRATCH}/roof.obj --radius 0.5 --keep ${SCRATCH}/on_roof.txt --round-size 16)
check(sample --domain 1x0.8x0.7 --torus --radius 0.4 --round-size 16)

# Relax: leaves that stick out of the lattice, and one with more sites than it has room for.
file(WRITE ${SCRATCH}/few.txt "0.1 0.2\n0.6 0.7\n0.9 0.3\n0.5 0.5\n0.52 0.5\n0.1 0.9\n")
check(relax ${SCRATCH}/few.txt --torus --iterations 2 --gaussian 2)
set(crowd "")
foreach(i RANGE 80)
    math(EXPR x "${i} % 9")
    math(EXPR y "${i} / 9")
    string(APPEND crowd "0.00${x}1 0.00${y}1\n")
endforeach()
file(WRITE ${SCRATCH}/crowd.txt "${crowd}")
check(relax ${SCRATCH}/crowd.txt --iterations 1)

# Mode cells: the test compares the sets with the cpu backend's.
foreach(metric min mean max)
    run_under_oclgrind(${CMAKE_COMMAND} -E env LACUNA_REQUIRE=opencl
        ${TESTS} --gtest_filter=*CellsSmallSet*/${metric})
    if(NOT printed MATCHES "PASSED.* 1 test")
        message(FATAL_ERROR "no test made a set of metric ${metric}: ${printed}")
    endif()
endforeach()
