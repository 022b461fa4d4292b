# One room, one library: tripoint_library(name SOURCES ... LINKS ...) and its tests: tripoint_test(room SOURCES ... LINKS ...).

add_library(tripoint_flags INTERFACE)
target_compile_features(tripoint_flags INTERFACE cxx_std_20)
target_include_directories(tripoint_flags INTERFACE ${PROJECT_SOURCE_DIR}/firmware)
target_compile_options(tripoint_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
  -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion -Wformat=2 -Wimplicit-fallthrough)
if(TRIPOINT_WARNINGS_AS_ERRORS)
  target_compile_options(tripoint_flags INTERFACE -Werror)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(tripoint_flags INTERFACE -march=x86-64-v2)
endif()
if(TRIPOINT_SANITIZE)
  target_compile_options(tripoint_flags INTERFACE -fsanitize=${TRIPOINT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(tripoint_flags INTERFACE -fsanitize=${TRIPOINT_SANITIZE})
endif()
if(TRIPOINT_FUZZ)  # every room tells the fuzzer which of its branches an input reached
  target_compile_options(tripoint_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(TRIPOINT_COVERAGE)
  target_compile_options(tripoint_flags INTERFACE --coverage -fprofile-update=atomic)  # threads count too
  target_link_options(tripoint_flags INTERFACE --coverage)
endif()
# GCC 12 and 14 warn of these falsely at -O2 and above: Eigen trips the bounds heuristics, std::string -Wrestrict
# (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(tripoint_flags INTERFACE -Wno-null-dereference -Wno-maybe-uninitialized -Wno-array-bounds
                         -Wno-stringop-overflow -Wno-restrict)
endif()

function(tripoint_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(tripoint_${name} STATIC ${ARG_SOURCES})
    target_link_libraries(tripoint_${name} PUBLIC ${ARG_LINKS} PRIVATE tripoint_flags)
    target_include_directories(tripoint_${name} PUBLIC ${PROJECT_SOURCE_DIR}/firmware)
    target_compile_features(tripoint_${name} PUBLIC cxx_std_20)
  else()
    add_library(tripoint_${name} INTERFACE)
    target_link_libraries(tripoint_${name} INTERFACE ${ARG_LINKS})
    target_include_directories(tripoint_${name} INTERFACE ${PROJECT_SOURCE_DIR}/firmware)
    target_compile_features(tripoint_${name} INTERFACE cxx_std_20)
  endif()
  add_library(tripoint::${name} ALIAS tripoint_${name})
endfunction()

# Where tests find files: the only source that knows an absolute path, so that a compiler cache serves every checkout.
if(TRIPOINT_TESTS)
  add_library(tripoint_test_places STATIC ${PROJECT_SOURCE_DIR}/tests/unit/places.cpp
              ${PROJECT_SOURCE_DIR}/tests/unit/scratch_folder.cpp)
  target_compile_definitions(tripoint_test_places PRIVATE TRIPOINT_TOP="${PROJECT_SOURCE_DIR}")
  target_link_libraries(tripoint_test_places PRIVATE tripoint_flags)
endif()

# One test program a room: fewer links, and ctest still lists every test.
function(tripoint_test room)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  if(NOT TRIPOINT_TESTS)
    return()
  endif()
  add_executable(test_${room} ${ARG_SOURCES})
  target_link_libraries(test_${room} PRIVATE ${ARG_LINKS} tripoint_test_places GTest::gmock GTest::gtest_main
                        tripoint_flags)
  target_include_directories(test_${room} PRIVATE ${PROJECT_SOURCE_DIR}/tests/unit)
  target_compile_options(test_${room} PRIVATE -O1)  # what is tested stays as it is built; its tests need no -O3
  gtest_discover_tests(test_${room} TEST_PREFIX "${room}." PROPERTIES TIMEOUT 120 DISCOVERY_TIMEOUT 60)
endfunction()
