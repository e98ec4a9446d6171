# The command lacuna-mpi, where there is MPI: what lacuna is made of, and a main of its own.
option(LACUNA_MPI "Build the command lacuna-mpi, where MPI is" ON)
include(${CMAKE_CURRENT_LIST_DIR}/leave_out.cmake)

function(lacuna_add_mpi)
    find_package(MPI QUIET COMPONENTS CXX)
    if(NOT MPI_CXX_FOUND)
        lacuna_leave_out("the command lacuna-mpi" mpi "MPI is missing" "libopenmpi-dev openmpi-bin")
        return()
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/mpi/*.cpp)
    add_executable(lacuna_mpi ${sources}
        $<FILTER:$<TARGET_OBJECTS:lacuna_command>,EXCLUDE,/main\\.cpp>)
    set_target_properties(lacuna_mpi PROPERTIES OUTPUT_NAME lacuna-mpi)
    target_include_directories(lacuna_mpi PRIVATE ${PROJECT_SOURCE_DIR}/host ${PROJECT_SOURCE_DIR}/kernels)
    target_include_directories(lacuna_mpi SYSTEM PRIVATE ${CLI11_INCLUDE_DIR} ${RANDOM123_INCLUDE_DIR})
    target_compile_definitions(lacuna_mpi PRIVATE LACUNA_VERSION="${PROJECT_VERSION}"
        OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
    target_link_libraries(lacuna_mpi PRIVATE
        $<TARGET_PROPERTY:lacuna_command,LINK_LIBRARIES> TBB::tbb MPI::MPI_CXX)
    set(LACUNA_HAS_MPI ON PARENT_SCOPE)
endfunction()

if(LACUNA_MPI)
    lacuna_add_mpi()
endif()
