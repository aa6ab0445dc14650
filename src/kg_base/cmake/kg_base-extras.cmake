# Build rules shared by every C++ package of this workspace; found with
# find_package(catkin REQUIRED COMPONENTS kg_base).
#
# File names are the rules: *_test.cc is a gtest, *_main.cc a program of that
# name without the suffix, *_fuzz.cc a libFuzzer target (with KG_FUZZ, which
# needs clang: scripts/fuzz.sh), every other .cc belongs to the package's library.
# testing/ holds what tests and benchmarks share: a library of its own.
#
# A package calls, in this order: kg_add_library(), kg_add_programs(),
# kg_add_tests(), kg_install(). Targets: `all` builds libraries and programs,
# `benches` the programs *_bench, `tests` the tests.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  #catkin_lint: ignore_once global_var_collision
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release is the default" FORCE)
endif()

# kg_optimize(-O2) in a package: its optimisation level in a Release build instead of
# -O3, which is kept for the arithmetic over grids. It shortens the build; its effect
# on the speed of these packages has not been measured.
macro(kg_optimize level)
  string(REPLACE "-O3" "${level}" CMAKE_CXX_FLAGS_RELEASE
         "${CMAKE_CXX_FLAGS_RELEASE}")
endmacro()

set(CMAKE_CXX_STANDARD 17)  # Never 20: generated message headers fail in it.
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
add_compile_options(-Wall -Wextra -Werror -fno-math-errno)

# Libraries are compiled in batches of sources: a quarter of the processor time.
# OFF compiles each file alone, which needs fewer recompilations while editing
# and gives clang-tidy the real commands.
#catkin_lint: ignore_once global_var_collision
option(KG_UNITY "Compile libraries in batches of sources" ON)
set(KG_BATCH 48)  # Headers are read once a batch, which takes up to 1.2 GB.
if(KG_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # The compiler collects garbage only above 1 GB: a tenth of its time.
  add_compile_options("SHELL:--param ggc-min-heapsize=1000000")
endif()

#catkin_lint: ignore_once global_var_collision
option(KG_FUZZ "Build the fuzzers, and everything for them" OFF)
#catkin_lint: ignore_once global_var_collision
set(KG_SANITIZE "" CACHE STRING "Sanitizers to build with: address,undefined")
if(KG_SANITIZE)
  # gcc 12 sees uninitialised values in instrumented std::function that are none.
  add_compile_options(-fsanitize=${KG_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${KG_SANITIZE})
endif()
if(KG_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Sets KG_SOURCES, KG_TESTS, KG_MAINS, KG_BENCHES, KG_FUZZERS and
# KG_TESTING_SOURCES from the folder ${PROJECT_NAME}.
macro(kg_find_sources)
  file(GLOB_RECURSE KG_SOURCES CONFIGURE_DEPENDS
       RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_NAME}/*.cc)
  set(KG_TESTS ${KG_SOURCES})
  list(FILTER KG_TESTS INCLUDE REGEX "_test\\.cc$")
  set(KG_MAINS ${KG_SOURCES})
  list(FILTER KG_MAINS INCLUDE REGEX "_main\\.cc$")
  set(KG_BENCHES ${KG_MAINS})
  list(FILTER KG_BENCHES INCLUDE REGEX "(_bench_main\\.cc$|/testing/)")
  list(FILTER KG_MAINS EXCLUDE REGEX "(_bench_main\\.cc$|/testing/)")
  set(KG_FUZZERS ${KG_SOURCES})
  list(FILTER KG_FUZZERS INCLUDE REGEX "_fuzz\\.cc$")
  list(FILTER KG_SOURCES EXCLUDE REGEX "_(test|main|fuzz)\\.cc$")
  set(KG_TESTING_SOURCES ${KG_SOURCES})
  list(FILTER KG_TESTING_SOURCES INCLUDE REGEX "/testing/")
  list(FILTER KG_SOURCES EXCLUDE REGEX "/testing/")
endmacro()

# The library of the package, of KG_SOURCES, in equal batches of about KG_BATCH
# sources. CMake keeps sources with compile options of their own out of the batches.
# ${PROJECT_NAME}_testing holds testing/*.cc, if there are any.
macro(kg_add_library)
  add_library(${PROJECT_NAME} ${KG_SOURCES})
  set_target_properties(${PROJECT_NAME} PROPERTIES
    UNITY_BUILD ${KG_UNITY} UNITY_BUILD_MODE GROUP)
  kg_group_sources(${KG_SOURCES})
  if(KG_TESTING_SOURCES)
    add_library(${PROJECT_NAME}_testing STATIC EXCLUDE_FROM_ALL
                ${KG_TESTING_SOURCES})
    target_link_libraries(${PROJECT_NAME}_testing ${PROJECT_NAME})
  endif()
endmacro()

# Gives each source the batch that it is compiled in: neighbours in the list, so
# that most of a folder is together and its headers are read once.
function(kg_group_sources)
  list(LENGTH ARGN count)
  math(EXPR batches "(${count} + ${KG_BATCH} - 1) / ${KG_BATCH}")
  set(index 0)
  foreach(source ${ARGN})
    math(EXPR batch "${index} * ${batches} / ${count}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${batch})
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()

# One program of a *_main.cc, named without the suffix; the arguments after the
# source are libraries. Sets KG_TARGET.
macro(kg_add_program source)
  get_filename_component(name ${source} NAME_WE)
  string(REGEX REPLACE "_main$" "" name ${name})
  set(KG_TARGET ${PROJECT_NAME}_${name})
  add_executable(${KG_TARGET} ${source})
  set_target_properties(${KG_TARGET} PROPERTIES OUTPUT_NAME ${name})
  target_link_libraries(${KG_TARGET} ${PROJECT_NAME} ${ARGN})
endmacro()

# Programs and benchmarks; the arguments are libraries. Sets KG_PROGRAMS, which
# are installed. The target `benches` builds benchmarks and the programs in testing/,
# the target `all` does not.
macro(kg_add_programs)
  set(KG_PROGRAMS)
  foreach(source ${KG_MAINS})
    kg_add_program(${source} ${ARGN})
    list(APPEND KG_PROGRAMS ${KG_TARGET})
  endforeach()
  if(NOT TARGET benches)
    add_custom_target(benches)
  endif()
  foreach(source ${KG_BENCHES})
    kg_add_program(${source} ${ARGN})
    set_target_properties(${KG_TARGET} PROPERTIES EXCLUDE_FROM_ALL ON)
    kg_link_testing(${KG_TARGET})
    add_dependencies(benches ${KG_TARGET})
  endforeach()
endmacro()

# Links the testing library of the package to a target, if there is one.
macro(kg_link_testing target)
  if(TARGET ${PROJECT_NAME}_testing)
    target_link_libraries(${target} ${PROJECT_NAME}_testing)
  endif()
endmacro()

# One gtest for each *_test.cc; the arguments are libraries.
macro(kg_add_tests)
  if(CATKIN_ENABLE_TESTING)
    foreach(source ${KG_TESTS})
      get_filename_component(name ${source} NAME_WE)
      catkin_add_gtest(${PROJECT_NAME}_${name} ${source}
                       WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
      target_link_libraries(${PROJECT_NAME}_${name} ${PROJECT_NAME} gtest_main
                            ${ARGN})
      kg_link_testing(${PROJECT_NAME}_${name})
      # A test is compiled for longer than it runs.
      target_compile_options(${PROJECT_NAME}_${name}
                             PRIVATE $<$<CONFIG:Release>:-O1>)
    endforeach()
  endif()
endmacro()

# One libFuzzer target for each *_fuzz.cc.
macro(kg_add_fuzzers)
  if(KG_FUZZ)
    foreach(source ${KG_FUZZERS})
      get_filename_component(name ${source} NAME_WE)
      add_executable(${PROJECT_NAME}_${name} ${source})
      set_target_properties(${PROJECT_NAME}_${name} PROPERTIES OUTPUT_NAME ${name})
      target_link_options(${PROJECT_NAME}_${name} PRIVATE -fsanitize=fuzzer)
      target_link_libraries(${PROJECT_NAME}_${name} ${PROJECT_NAME})
    endforeach()
  endif()
endmacro()

# Installs library, programs and headers; those under testing/ are not installed.
macro(kg_install)
  install(TARGETS ${PROJECT_NAME} ${KG_PROGRAMS}
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  install(DIRECTORY ${PROJECT_NAME}/
    DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION}
    FILES_MATCHING PATTERN "*.h"
    PATTERN testing EXCLUDE)
endmacro()
