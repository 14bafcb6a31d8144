# Language level, warnings and sanitizers: one interface target that every room links.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(finback_settings INTERFACE)
target_include_directories(finback_settings INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(finback_settings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Werror
                       -Wno-restrict)  # false alarms of g++ 12 on std::string (its bug 105651)
# Results may not depend on the host: no fused or reordered floating point.
target_compile_options(finback_settings INTERFACE -ffp-contract=off)
if(FINBACK_SANITIZE)
  # A null pointer is seen by the address sanitizer: to ask at each use as well costs a fifth of the build.
  target_compile_options(finback_settings INTERFACE -fsanitize=address,undefined
                         -fno-sanitize=null,object-size,vptr
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(finback_settings INTERFACE -fsanitize=address,undefined)
endif()

# finback_library(NAME sources...): a room. Link what it knows of with target_link_libraries.
function(finback_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC finback_settings)
endfunction()

# finback_runs_once(NAME): code around a run, no part of its loops. Under the sanitizers most of compiling it is
# optimising the templates of other libraries, for nothing. (Not in a release: where the linker has the choice, an
# inline function of the simulator would be taken from here.)
function(finback_runs_once name)
  if(FINBACK_SANITIZE)
    target_compile_options(${name} PRIVATE -O0)
  endif()
endfunction()

# Tests are compiled once and run for seconds: what they test is optimised, they need not be. Of their own
# code the address sanitizer alone takes care: undefined behaviour is looked for in what they test, and to
# look for it in GoogleTest's templates too, optimised, takes twice as long to build.
set(FINBACK_TEST_OPTIONS
    -Wno-array-bounds -Wno-stringop-overflow)  # false alarms, as above, when headers are precompiled
if(FINBACK_SANITIZE)
  list(APPEND FINBACK_TEST_OPTIONS -O0 -fno-sanitize=undefined)
else()
  list(APPEND FINBACK_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)
endif()

# finback_test(NAME sources... [LIBRARIES libs...] [LABELS labels...]): a GoogleTest program; each of
# its tests is one ctest test. Of compiling one, most is reading GoogleTest's headers: they are
# compiled once for all.
function(finback_test name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;LABELS" ${ARGN})
  if(NOT TARGET finback_test_headers)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/test_headers.cpp CONTENT "")
    add_library(finback_test_headers OBJECT ${CMAKE_BINARY_DIR}/test_headers.cpp)
    target_link_libraries(finback_test_headers PRIVATE finback_settings GTest::gtest_main GTest::gmock)
    target_compile_options(finback_test_headers PRIVATE ${FINBACK_TEST_OPTIONS})
    target_precompile_headers(finback_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
  endif()
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} finback_settings GTest::gtest_main GTest::gmock)
  target_compile_options(${name} PRIVATE ${FINBACK_TEST_OPTIONS})
  if(NOT ARG_UNPARSED_ARGUMENTS MATCHES "\\.c(;|$)")  # they are for C++ alone
    target_precompile_headers(${name} REUSE_FROM finback_test_headers)
  endif()
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${ARG_LABELS}")
endfunction()

find_package(fmt REQUIRED)
find_package(GTest REQUIRED)
include(GoogleTest)
