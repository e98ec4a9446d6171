# lacuna-mpi under mpirun: equality with lacuna on 1, 2, 3, 5 and 7 ranks, and faults. Waiting ranks
# give their cores to other processes and are slow to get them back, so these tests run alone.
set(mpi_environment "OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_btl_tcp_if_include=lo;POCL_CACHE_DIR=${pocl_cache}")
add_executable(mpi_equality ${CMAKE_CURRENT_LIST_DIR}/equality.cpp)
target_include_directories(mpi_equality PRIVATE
    ${PROJECT_SOURCE_DIR}/kernels ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(mpi_equality PRIVATE lacuna_mpi_ranks lacuna_options)
foreach(ranks IN ITEMS 1 2 3 5 7)
    add_test(NAME mpi.equality.${ranks} COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe --bind-to none
        -n ${ranks} $<TARGET_FILE:mpi_equality> ${PROJECT_BINARY_DIR}/equality-${ranks}.npy)
    set_tests_properties(mpi.equality.${ranks} PROPERTIES RUN_SERIAL ON TIMEOUT 600 ENVIRONMENT "${mpi_environment}"
        PASS_REGULAR_EXPRESSION "^(60|65|70) sets on up to ${ranks} ranks, 0 different")
endforeach()

add_executable(mpi_test ${CMAKE_CURRENT_LIST_DIR}/command_test.cpp
    ${CMAKE_CURRENT_LIST_DIR}/faults_test.cpp ${CMAKE_CURRENT_SOURCE_DIR}/cli/program.cpp)
target_include_directories(mpi_test PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(mpi_test PRIVATE LACUNA_PROGRAM="$<TARGET_FILE:lacuna_command>"
    LACUNA_MPI_PROGRAM="$<TARGET_FILE:lacuna_mpi>" LACUNA_MPIRUN="${MPIEXEC_EXECUTABLE}")
target_compile_features(mpi_test PRIVATE cxx_std_20)
target_compile_options(mpi_test PRIVATE $<$<CONFIG:Release>:-O1>)
target_link_libraries(mpi_test PRIVATE lacuna_options GTest::gtest_main)
add_dependencies(mpi_test lacuna_command lacuna_mpi)
gtest_discover_tests(mpi_test TEST_PREFIX mpi. DISCOVERY_TIMEOUT 600
    PROPERTIES RUN_SERIAL ON TIMEOUT 600 ENVIRONMENT "${mpi_environment}")
