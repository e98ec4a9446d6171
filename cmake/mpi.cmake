# The command lacuna-mpi, where MPI is installed: lacuna's libraries with another main.
option(LACUNA_MPI "Build the command lacuna-mpi, where MPI is" ON)
include(${CMAKE_CURRENT_LIST_DIR}/leave_out.cmake)

function(lacuna_add_mpi)
    find_package(MPI QUIET COMPONENTS CXX)
    if(NOT MPI_CXX_FOUND)
        lacuna_leave_out("the command lacuna-mpi" mpi "MPI is missing" "libopenmpi-dev openmpi-bin")
        return()
    endif()
    set(folder ${PROJECT_SOURCE_DIR}/host/mpi)
    # The code of the ranks and of their file is a library, because tests use it too.
    add_library(lacuna_mpi_ranks STATIC
        ${folder}/mpi_ranks.cpp ${folder}/npy_sink.cpp ${folder}/unfinished_file.cpp)
    target_include_directories(lacuna_mpi_ranks SYSTEM PRIVATE ${RANDOM123_INCLUDE_DIR})
    target_compile_definitions(lacuna_mpi_ranks PUBLIC OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
    target_link_libraries(lacuna_mpi_ranks PUBLIC lacuna_files MPI::MPI_CXX
        PRIVATE lacuna_options TBB::tbb)
    add_executable(lacuna_mpi ${folder}/main.cpp ${folder}/endings.cpp ${folder}/report.cpp
        ${folder}/sample.cpp
        $<FILTER:$<TARGET_OBJECTS:lacuna_command>,EXCLUDE,/main\\.cpp>)
    set_target_properties(lacuna_mpi PROPERTIES OUTPUT_NAME lacuna-mpi)
    target_include_directories(lacuna_mpi PRIVATE ${PROJECT_SOURCE_DIR}/host)
    target_include_directories(lacuna_mpi SYSTEM PRIVATE ${CLI11_INCLUDE_DIR} ${RANDOM123_INCLUDE_DIR})
    target_link_libraries(lacuna_mpi PRIVATE lacuna_mpi_ranks
        $<TARGET_PROPERTY:lacuna_command,LINK_LIBRARIES> TBB::tbb)
    set(MPIEXEC_EXECUTABLE ${MPIEXEC_EXECUTABLE} PARENT_SCOPE)
    set(LACUNA_HAS_MPI ON PARENT_SCOPE)
endfunction()

if(LACUNA_MPI)
    lacuna_add_mpi()
endif()
