# Script: counts the instructions of the cpu backend's loop on one thread, because seconds on a
# shared machine vary too much, and fails when one mode takes over 10 % more than BASELINE says.
# PROGRAM is the command, SOURCE the repository, SCRATCH a folder to write to, BUILD the compiler.
# With -D UPDATE=ON the baseline is written instead.
find_program(VALGRIND valgrind)
if(NOT VALGRIND)
    message("SKIPPED: valgrind is not installed")
    return()
endif()
file(READ ${BASELINE} baseline)
string(JSON baseline_build GET "${baseline}" build)
if(NOT UPDATE AND NOT BUILD STREQUAL baseline_build)
    message("SKIPPED: this is ${BUILD}, the baseline is of ${baseline_build}")
    return()
endif()
file(MAKE_DIRECTORY ${SCRATCH})

# Sets RESULT to the number of instructions between the first draw and the last sample.
function(count_instructions result)
    execute_process(
        COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=/dev/null
            "--toggle-collect=lacuna::OutcomeOf<lacuna::Sample> lacuna::generate*" ${PROGRAM} ${ARGN} --backend cpu --threads 1
            --quiet -o ${SCRATCH}/points.npy
        RESULT_VARIABLE code ERROR_VARIABLE said)
    if(NOT code EQUAL 0 OR NOT said MATCHES "Collected : ([1-9][0-9]*)")
        message(FATAL_ERROR "${ARGN}: exit code ${code}, no count in: ${said}")
    endif()
    set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

function(check mode)
    count_instructions(count ${ARGN})
    if(UPDATE)
        string(JSON baseline SET "${baseline}" ${mode} ${count})
        set(baseline "${baseline}" PARENT_SCOPE)
        return()
    endif()
    string(JSON expected GET "${baseline}" ${mode})
    math(EXPR percent "${count} * 100 / ${expected}")
    message("${mode}: ${count} instructions, ${percent} % of the baseline's")
    if(percent GREATER 110)
        message(FATAL_ERROR "${mode}: ${count} instructions are over 10 % more than the "
            "baseline's ${expected}: mend it, or say in the commit why a new baseline stands")
    endif()
endfunction()

check(exact sample --radius 0.005 --torus)
check(lines sample --mode lines --radius 0.005 --torus)
check(cells stipple ${SOURCE}/examples/raccoon.png --scale 0.005 --relax 0)
check(field sample --field ${SOURCE}/examples/raccoon.png --scale 0.006)
check(classes sample --class near:2 --class far:5 --between union --torus --count 5000)
check(ellipses sample --stretch 0.02:0.005@30)
if(UPDATE)
    string(JSON baseline SET "${baseline}" build "\"${BUILD}\"")
    file(WRITE ${BASELINE} "${baseline}\n")
endif()
