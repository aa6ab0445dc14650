# Build rules shared by every C++ package of this workspace; found with
# find_package(catkin REQUIRED COMPONENTS kg_core).
#
# File names are the rules: *_test.cc is a gtest, *_main.cc a program of that
# name without the suffix, *_fuzz.cc a libFuzzer target (with KG_FUZZ, which
# needs clang: scripts/fuzz.sh), every other .cc belongs to the package's library.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  #catkin_lint: ignore_once global_var_collision
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release is the default" FORCE)
endif()

set(CMAKE_CXX_STANDARD 17)  # Never 20: generated message headers fail in it.
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
add_compile_options(-Wall -Wextra -Werror -fno-math-errno)

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

# Sets KG_SOURCES, KG_TESTS, KG_MAINS and KG_FUZZERS from the folder ${PROJECT_NAME}.
macro(kg_find_sources)
  file(GLOB_RECURSE KG_SOURCES CONFIGURE_DEPENDS
       RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_NAME}/*.cc)
  set(KG_TESTS ${KG_SOURCES})
  list(FILTER KG_TESTS INCLUDE REGEX "_test\\.cc$")
  set(KG_MAINS ${KG_SOURCES})
  list(FILTER KG_MAINS INCLUDE REGEX "_main\\.cc$")
  set(KG_FUZZERS ${KG_SOURCES})
  list(FILTER KG_FUZZERS INCLUDE REGEX "_fuzz\\.cc$")
  list(FILTER KG_SOURCES EXCLUDE REGEX "_(test|main|fuzz)\\.cc$")
endmacro()

# One program for each *_main.cc, named without the suffix. Sets KG_PROGRAMS.
macro(kg_add_programs)
  set(KG_PROGRAMS)
  foreach(source ${KG_MAINS})
    get_filename_component(name ${source} NAME_WE)
    string(REGEX REPLACE "_main$" "" name ${name})
    add_executable(${PROJECT_NAME}_${name} ${source})
    set_target_properties(${PROJECT_NAME}_${name} PROPERTIES OUTPUT_NAME ${name})
    target_link_libraries(${PROJECT_NAME}_${name} ${PROJECT_NAME} ${ARGN})
    list(APPEND KG_PROGRAMS ${PROJECT_NAME}_${name})
  endforeach()
endmacro()

# One gtest for each *_test.cc.
macro(kg_add_tests)
  if(CATKIN_ENABLE_TESTING)
    foreach(source ${KG_TESTS})
      get_filename_component(name ${source} NAME_WE)
      catkin_add_gtest(${PROJECT_NAME}_${name} ${source}
                       WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
      target_link_libraries(${PROJECT_NAME}_${name} ${PROJECT_NAME} gtest_main
                            ${ARGN})
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
